//! Who listens to the keys.

macro_rules! modes {
    ($($(#[$doc:meta])* $variant:ident, $name:literal, $place:literal;)*) => {
        /// Who listens to the keys.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Mode {
            $($(#[$doc])* $variant,)*
        }

        impl Mode {
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            /// Its table in the file of keys.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// Where it is, as the title of what its keys do.
            pub fn place(self) -> &'static str {
                match self {
                    $(Self::$variant => $place,)*
                }
            }
        }
    };
}

modes! {
    /// The list of designs.
    Library, "library", "In the list of designs";
    /// The error text of a broken design.
    Text, "text", "In the text about a design";
    /// The filter is being typed.
    Filter, "filter", "While the filter is typed";
    Help, "help", "In this help";
    /// What the help is searched for is being typed.
    HelpSearch, "help-search", "While the help is searched";
    /// An action's name is being typed.
    Palette, "palette", "In the list of all actions";
    /// A file's name is being typed.
    Name, "name", "While a file is named";
    /// The form of a new design.
    New, "new", "In the form of a new design";
    /// A question with yes or no.
    Confirm, "confirm", "When asked whether to delete";
    /// All messages in full.
    Messages, "messages", "In the messages";
    /// Two designs beside one another.
    Compare, "compare", "In the comparison";
    /// The spectra over the whole window.
    Spectra, "spectra", "Over the spectra";
    /// Why models disagree in a band.
    Why, "why", "In the reasons for a band";
    /// The name of a file to write to is being typed.
    Export, "export", "While a file to write is named";
    /// The natural modes of a design.
    Modes, "modes", "In the natural modes";
    /// The frequency of a deflection shape is being typed.
    Frequency, "frequency", "While a frequency is typed";
    /// All designs with their figures.
    Overview, "overview", "In the overview of designs";
    /// The bearings of a design under load.
    Bearings, "bearings", "In the bearings under load";
    /// The torque is being typed.
    Torque, "torque", "While a torque is typed";
    /// The gear pair of a design.
    Pair, "gear-pair", "In the gear pair";
    /// The face width for an estimate is being typed.
    FaceWidth, "face-width", "While a face width is typed";
    /// The file with mesh numbers is being named.
    MeshFile, "mesh-file", "While a table of mesh numbers is named";
    /// What a table of mesh numbers would change.
    MeshImport, "mesh-import", "When shown what an import changes";
    /// The tables of a design.
    Table, "table", "In the tables";
    /// A cell is being typed into.
    Cell, "cell", "While a cell is typed into";
    /// The words that a cell may hold.
    Choice, "choice", "In a list of words";
    /// The stiffness matrix of a bearing.
    Matrix, "matrix", "In a stiffness matrix";
    /// The list of findings.
    Findings, "findings", "In the list of findings";
    /// Name and note of a variant are being typed.
    Form, "form", "While a variant is named";
    /// What to do with edits that are not saved.
    Leave, "leave", "When asked about unsaved edits";
    /// What to do with edits of an earlier run.
    Recovery, "recovery", "When asked about edits of an earlier run";
    /// What to do where somebody else has changed the file.
    Conflict, "conflict", "When asked about somebody else's change";
}

impl Mode {
    /// Whether letters are text.
    pub fn is_typing(self) -> bool {
        super::places::TYPING.contains(&self)
    }
}
