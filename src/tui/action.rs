//! What the user can do: one table, from which the help, the palette, the hints in the footer and the names for remapping are
//! made.

/// Where the help lists an action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    Move,
    Find,
    Designs,
    Typing,
    Program,
}

impl Category {
    pub const ALL: [Self; 5] = [Self::Move, Self::Find, Self::Designs, Self::Typing, Self::Program];

    pub fn title(self) -> &'static str {
        match self {
            Self::Move => "Moving",
            Self::Find => "Finding",
            Self::Designs => "Designs",
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
    MoveUp, "move-up", Move, "the design above, or a line up", hint 0 "move";
    MoveDown, "move-down", Move, "the design below, or a line down", hint 0 "move";
    PageUp, "page-up", Move, "a page up";
    PageDown, "page-down", Move, "a page down";
    First, "first", Move, "the first design or line";
    Last, "last", Move, "the last design or line";
    NextPane, "next-pane", Move, "to the error text and back to the designs", hint 2 "next pane";
    Filter, "filter", Find, "only what has these letters in it", hint 3 "filter";
    NextMatch, "next-match", Find, "the next match; after the last the first", hint 4 "match";
    PreviousMatch, "previous-match", Find, "the match before", hint 4 "match";
    ToggleTree, "toggle-tree", Find, "variants below the design they came from, or all by name";
    Mark, "mark", Designs, "mark the design to compare others with, or unmark it", hint 8 "mark";
    Compare, "compare", Designs, "compare with the marked design, else with the parent", hint 7 "compare";
    Rename, "rename", Designs, "rename the design's file", hint 9 "rename";
    Duplicate, "duplicate", Designs, "copy the design to another file", hint 9 "duplicate";
    Delete, "delete", Designs, "move the design to the trash; asks first", hint 9 "delete";
    RestoreDeleted, "restore-deleted", Designs, "bring back what was deleted last";
    KeepFilter, "keep-filter", Typing, "keep the filter and go back", hint 1 "keep filter";
    TextLeft, "text-left", Typing, "a letter to the left";
    TextRight, "text-right", Typing, "a letter to the right";
    TextStart, "text-start", Typing, "before the first letter";
    TextEnd, "text-end", Typing, "after the last letter";
    DeleteCharacter, "delete-character", Typing, "delete the letter before the cursor";
    DeleteForward, "delete-forward", Typing, "delete the letter under the cursor";
    ClearText, "clear-text", Typing, "delete all letters";
    Accept, "accept", Program, "do what is asked or chosen", hint 0 "accept";
    Back, "back", Program, "one level back; never quits", hint 2 "back";
    Reread, "reread", Program, "read the folder and the designs again", hint 6 "reread";
    Redraw, "redraw", Program, "draw the whole screen again";
    Suspend, "suspend", Program, "suspend; fg in the shell comes back";
    Palette, "palette", Program, "all actions by name", hint 5 "commands";
    Messages, "messages", Program, "all messages in full, the latest first";
    Help, "help", Program, "this help", hint 5 "help";
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
