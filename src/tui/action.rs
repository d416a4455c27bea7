//! What the user can do: one table, from which the help, the palette, the hints in the footer and the names for remapping are
//! made.

/// Where the help lists an action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    Move,
    Find,
    Designs,
    Edit,
    Solve,
    Spectra,
    Typing,
    Program,
}

impl Category {
    pub const ALL: [Self; 8] =
        [Self::Move, Self::Find, Self::Designs, Self::Edit, Self::Solve, Self::Spectra, Self::Typing, Self::Program];

    pub fn title(self) -> &'static str {
        match self {
            Self::Move => "Moving",
            Self::Find => "Finding",
            Self::Designs => "Designs",
            Self::Edit => "Editing",
            Self::Solve => "Solving",
            Self::Spectra => "Spectra",
            Self::Typing => "While something is typed",
            Self::Program => "Program",
        }
    }
}

/// A hint in the footer. Actions with the same text share one hint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hint {
    pub text: &'static str,
    /// The lowest number stays longest when there is little room.
    pub priority: u8,
}

/// What the table says about one action.
#[derive(Debug, Clone, Copy)]
pub struct About {
    pub action: Action,
    pub name: &'static str,
    pub doc: &'static str,
    pub category: Category,
    pub hint: Option<Hint>,
}

macro_rules! actions {
    ($($variant:ident, $name:literal, $category:ident, $doc:literal $(, hint $priority:literal $hint:literal)?;)*) => {
        /// Something a key does.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Action {
            $(#[doc = $doc] $variant,)*
        }

        /// All actions, in the order of the help.
        pub const ACTIONS: &[About] = &[$(About {
            action: Action::$variant,
            name: $name,
            doc: $doc,
            category: Category::$category,
            hint: actions!(@hint $($priority $hint)?),
        },)*];
    };
    (@hint) => { None };
    (@hint $priority:literal $hint:literal) => { Some(Hint { text: $hint, priority: $priority }) };
}

actions! {
    MoveUp, "move-up", Move, "a design, row or line up", hint 0 "move";
    MoveDown, "move-down", Move, "a design, row or line down", hint 0 "move";
    PageUp, "page-up", Move, "a page up";
    PageDown, "page-down", Move, "a page down";
    First, "first", Move, "the first design, row or line";
    Last, "last", Move, "the last design, row or line";
    MoveLeft, "move-left", Move, "a cell to the left";
    MoveRight, "move-right", Move, "a cell to the right";
    FirstCell, "first-cell", Move, "the first cell of the row";
    LastCell, "last-cell", Move, "the last cell of the row";
    NextCell, "next-cell", Move, "the next cell; after the last the next row", hint 7 "next cell";
    PreviousCell, "previous-cell", Move, "the cell before";
    OtherShaft, "other-shaft", Move, "the same table of the other shaft";
    NextTable, "next-table", Move, "the next table";
    PreviousTable, "previous-table", Move, "the table before";
    Segments, "segments", Move, "the segments of a shaft";
    Bearings, "bearings", Move, "the bearings of a shaft";
    Bodies, "bodies", Move, "the bodies on a shaft";
    Mesh, "mesh", Move, "the mesh, and where it is on a shaft";
    Drives, "drives", Move, "the drive of a shaft";
    Analysis, "analysis", Move, "frequency lines, damping, beam theory";
    Materials, "materials", Move, "the materials";
    Design, "design", Move, "name, description, tags, parent and note";
    NextPane, "next-pane", Move, "to the error text and back to the designs", hint 2 "next pane";
    Filter, "filter", Find, "only what has these letters in it", hint 3 "filter";
    NextMatch, "next-match", Find, "the next match; after the last the first", hint 4 "match";
    PreviousMatch, "previous-match", Find, "the match before", hint 4 "match";
    ToggleTree, "toggle-tree", Find, "variants below the design they came from, or all by name";
    Mark, "mark", Designs, "mark the design to compare others with, or unmark it", hint 8 "mark";
    Compare, "compare", Designs, "compare with the marked design, else with the parent", hint 7 "compare";
    Modes, "modes", Designs, "natural modes, shapes and partners; over the spectra: the deflection at the cursor", hint 5 "modes";
    NextPhase, "next-phase", Move, "the shape an eighth of a period later", hint 2 "phase";
    OtherModel, "other-model", Move, "the enhanced, the basic or the reduced model beside finite elements", hint 3 "model";
    ShowMac, "mac", Find, "the MAC of all modes as a picture, or the table", hint 3 "MAC";
    Deflection, "deflection", Find, "the operating deflection shape in place of the mode, or back", hint 3 "deflection";
    TypeFrequency, "type-frequency", Find, "the operating deflection shape at a frequency that is typed", hint 4 "frequency";
    Overview, "overview", Designs, "a table of all designs with their figures", hint 6 "overview";
    ShowDesign, "show-design", Designs, "to the design under the cursor", hint 1 "go there";
    SortColumn, "sort-column", Find, "order the designs by the next column", hint 2 "sort";
    PreviousColumn, "previous-column", Find, "order the designs by the column before";
    SortDirection, "sort-direction", Find, "the other way round", hint 4 "reverse";
    Swap, "swap", Designs, "swap A and B of the comparison", hint 3 "swap";
    Rename, "rename", Designs, "rename the design's file", hint 9 "rename";
    Duplicate, "duplicate", Designs, "copy the design to another file", hint 9 "duplicate";
    Delete, "delete", Designs, "move the design to the trash; asks first", hint 9 "delete";
    NewDesign, "new-design", Designs, "a new design from a few questions", hint 9 "new";
    CreateDesign, "create-design", Designs, "write the new design as the form has it", hint 0 "create";
    RestoreDeleted, "restore-deleted", Designs, "bring back what was deleted last";
    KeepFilter, "keep-filter", Typing, "keep the filter and go back", hint 1 "keep filter";
    TextLeft, "text-left", Typing, "a letter to the left";
    TextRight, "text-right", Typing, "a letter to the right";
    TextStart, "text-start", Typing, "before the first letter";
    TextEnd, "text-end", Typing, "after the last letter";
    DeleteCharacter, "delete-character", Typing, "delete the letter before the cursor";
    DeleteForward, "delete-forward", Typing, "delete the letter under the cursor";
    ClearText, "clear-text", Typing, "delete all letters before the cursor", hint 2 "clear";
    Accept, "accept", Program, "do what is asked or chosen", hint 0 "accept";
    OpenEditor, "edit-design", Edit, "open the tables of the design", hint 1 "edit";
    EditCell, "edit-cell", Edit, "type into the cell, open its list or its matrix; digits and - + . begin a number", hint 0 "edit";
    ReplaceCell, "replace-cell", Edit, "type in place of the value";
    CycleCell, "cycle-cell", Edit, "the next of the words that the cell may hold", hint 1 "next word";
    ClearCell, "clear-cell", Edit, "clear the cell, so that its default holds", hint 7 "clear";
    AddRow, "add-row", Edit, "add a row below; a drive where the shaft has none", hint 3 "add row";
    InsertRow, "insert-row", Edit, "add a row above";
    DuplicateRow, "duplicate-row", Edit, "add a copy of the row below it", hint 6 "duplicate";
    DeleteRow, "delete-row", Edit, "delete the row, or the drive of the shaft", hint 6 "delete row";
    MoveRowUp, "move-row-up", Edit, "move the row up";
    MoveRowDown, "move-row-down", Edit, "move the row down";
    Undo, "undo", Edit, "take the last edit back", hint 3 "undo";
    Redo, "redo", Edit, "make it again", hint 6 "redo";
    Save, "save", Edit, "save the design", hint 2 "save";
    SaveVariant, "save-variant", Edit, "save as a variant beside the design", hint 7 "variant";
    AcceptCell, "accept-cell", Typing, "accept what was typed, and a row down", hint 0 "accept";
    AcceptNext, "accept-next", Typing, "accept what was typed, and the next cell", hint 1 "accept, next";
    AcceptPrevious, "accept-previous", Typing, "accept what was typed, and the cell before";
    Choose, "choose", Edit, "take the word under the cursor, or those that are ticked", hint 1 "take";
    Tick, "tick", Edit, "tick the word under the cursor, or not", hint 1 "tick";
    DeleteWord, "delete-word", Typing, "delete the word before the cursor";
    SaveForm, "save-form", Edit, "save the variant", hint 0 "save";
    NextField, "next-field", Typing, "name or note", hint 1 "name/note";
    SaveAll, "save-all", Edit, "save all designs and quit", hint 0 "save all";
    DiscardAll, "discard-all", Edit, "quit without the edits that are not saved", hint 1 "discard";
    Recover, "recover", Edit, "unsaved edits that an earlier run has left";
    TakeEdits, "take-edits", Edit, "open the tables with the edits of the earlier run; can be undone", hint 0 "take";
    DiscardEdits, "discard-edits", Edit, "put the edits of the earlier run aside", hint 1 "discard";
    NextOffer, "next-offer", Edit, "the next design with edits of an earlier run", hint 3 "next";
    KeepMine, "keep-mine", Edit, "write over what somebody else has saved, as it is shown", hint 0 "keep mine";
    TakeTheirs, "take-theirs", Edit, "take what somebody else has saved; undo brings the edits back", hint 1 "take theirs";
    Findings, "findings", Find, "what is wrong or unusual in the design", hint 4 "findings";
    GoToFinding, "go-to-finding", Find, "to the cell that the finding is about", hint 0 "go there";
    RemoveKey, "remove-key", Edit, "take out a key that no table has", hint 1 "remove key";
    Solve, "solve", Solve, "solve the design as it is now", hint 2 "solve";
    ToggleLive, "toggle-live", Solve, "solve after each edit, or not", hint 8 "live";
    CancelSolve, "cancel-solve", Solve, "stop solving", hint 0 "stop solving";
    Back, "back", Program, "one level back; never quits", hint 2 "back";
    Reread, "reread", Program, "read the folder and the designs again", hint 6 "reread";
    Redraw, "redraw", Program, "draw the whole screen again";
    Suspend, "suspend", Program, "suspend; fg in the shell comes back";
    CycleMarker, "cycle-marker", Program, "curves of braille, blocks, dots or ASCII";
    ToggleBackground, "toggle-background", Program, "colours for a dark or for a light background";
    Copy, "copy", Program, "copy what the cursor is on through the terminal: figures, cell, differences or text";
    CopyPath, "copy-path", Program, "copy the path of the design through the terminal";
    Palette, "palette", Program, "all actions by name", hint 5 "commands";
    Messages, "messages", Program, "all messages in full, the latest first";
    Help, "help", Program, "this help", hint 5 "help";
    OpenSpectra, "spectra", Solve, "the spectra over the whole window: cursor, zoom, bands of disagreement and why", hint 8 "wide";
    JumpLeft, "jump-left", Spectra, "the cursor ten columns to the left";
    JumpRight, "jump-right", Spectra, "the cursor ten columns to the right";
    ZoomIn, "zoom-in", Spectra, "half the frequencies, around the cursor", hint 2 "zoom";
    ZoomOut, "zoom-out", Spectra, "twice the frequencies, around the cursor", hint 2 "zoom";
    ZoomFit, "zoom-fit", Spectra, "all frequencies", hint 6 "fit";
    PanLeft, "pan-left", Spectra, "a quarter of the window to the left";
    PanRight, "pan-right", Spectra, "a quarter of the window to the right";
    NextQuantity, "next-quantity", Spectra, "mesh force, transmission error, the force of each bearing", hint 3 "quantity";
    PreviousQuantity, "previous-quantity", Spectra, "the quantity before";
    NextDirection, "next-direction", Spectra, "resultant, x, y, z or radial force of the bearing", hint 6 "direction";
    ShowFe, "show-fe", Spectra, "the finite element model's curve, or not";
    ShowEnhanced, "show-enhanced", Spectra, "the enhanced model's curve, or not";
    ShowBasic, "show-basic", Spectra, "the basic model's curve, or not";
    ShowReduced, "show-reduced", Spectra, "the reduced model's curve, or not";
    MoreModes, "more-modes", Spectra, "a mode more in each rotor of the reduced model";
    FewerModes, "fewer-modes", Spectra, "a mode less in each rotor of the reduced model";
    NextAgainst, "next-against", Spectra, "the model held against finite elements: enhanced, basic, reduced";
    LogFrequency, "log-frequency", Spectra, "frequencies logarithmic or linear";
    LinearLevel, "linear-level", Spectra, "values in dB or in their unit";
    NextPanel, "next-panel", Spectra, "below: difference, phase, the other quantity of the mesh, sixth-octave levels", hint 4 "panel";
    LessTolerance, "less-tolerance", Spectra, "a tolerance 1 dB smaller";
    MoreTolerance, "more-tolerance", Spectra, "a tolerance 1 dB larger";
    NextBand, "next-band", Spectra, "the next band beyond the tolerance; after the last the first", hint 1 "band";
    PreviousBand, "previous-band", Spectra, "the band before", hint 1 "band";
    NextPeak, "next-peak", Spectra, "the next peak; after the last the first", hint 3 "peak";
    PreviousPeak, "previous-peak", Spectra, "the peak before", hint 3 "peak";
    ListPeaks, "list-peaks", Spectra, "list the bands, the peaks and their pairs, or nothing", hint 7 "list";
    Why, "why", Spectra, "why the models disagree in the band at the cursor", hint 0 "why";
    ExportShown, "export-shown", Program, "write what is shown to a file: .csv, .svg or .html", hint 6 "write";
    BearingLoads, "bearing-loads", Solve, "the bearings under load: mean loads, loaded elements, contact angles, stiffness", hint 7 "bearings";
    MoreTorque, "more-torque", Solve, "a step more torque on the pinion, up to 5 %", hint 1 "torque";
    LessTorque, "less-torque", Solve, "a step less torque on the pinion, up to 5 %", hint 1 "torque";
    MuchMoreTorque, "much-more-torque", Solve, "a large step more torque, up to 25 %", hint 6 "large step";
    MuchLessTorque, "much-less-torque", Solve, "a large step less torque, up to 25 %", hint 6 "large step";
    TypeTorque, "type-torque", Solve, "type the torque of the pinion, as 300, 0.3 kN m or 221 lbf ft", hint 3 "type it";
    NextElement, "next-element", Move, "the next element of the bearing, round from +z towards +x", hint 5 "element";
    PreviousElement, "previous-element", Move, "the element before", hint 5 "element";
    NextView, "next-view", Find, "spectra, 6x6 or element loads, where there is no room for all", hint 2 "6x6/spectra";
    GearPair, "gear-pair", Designs, "the gear pair: forces on both shafts in numbers and to scale, stiffness estimate, import", hint 8 "gear pair";
    FlipFlank, "flip-flank", Edit, "the pinion turns the other way: the other flank carries the load", hint 1 "flip flank";
    EstimateStiffness, "estimate-stiffness", Edit, "an estimate of the mesh stiffness from a face width that is typed", hint 1 "stiffness";
    ImportMesh, "import-mesh", Edit, "mesh point, line of action, stiffness and transmission error from a CSV file", hint 1 "import";
    OtherValue, "other-value", Typing, "the other value: face width or angle", hint 1 "width/angle";
    OtherFlank, "other-flank", Edit, "the other flank of the table: drive or coast", hint 1 "drive/coast";
    Quit, "quit", Program, "quit", hint 5 "quit";
}

impl Action {
    /// The table's row of this action.
    pub fn about(self) -> Option<&'static About> {
        ACTIONS.iter().find(|about| about.action == self)
    }

    /// As in the table.
    pub fn name(self) -> &'static str {
        self.about().map_or("", |about| about.name)
    }
}
