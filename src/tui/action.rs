//! What the user can do: one table, from which the help and the hints in the footer are made.

/// Where the help lists an action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    Move,
    Find,
    Program,
}

impl Category {
    pub const ALL: [Self; 3] = [Self::Move, Self::Find, Self::Program];

    pub fn title(self) -> &'static str {
        match self {
            Self::Move => "Moving",
            Self::Find => "Finding",
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
    Filter, "filter", Find, "only designs with these letters in a name", hint 3 "filter";
    KeepFilter, "keep-filter", Find, "keep the filter and go back to the designs", hint 1 "keep filter";
    NextMatch, "next-match", Find, "the next match; after the last the first", hint 4 "match";
    PreviousMatch, "previous-match", Find, "the match before", hint 4 "match";
    DeleteCharacter, "delete-character", Find, "delete the last letter of the filter";
    ClearText, "clear-text", Find, "delete all letters of the filter";
    Back, "back", Program, "one level back; never quits", hint 2 "back";
    Reread, "reread", Program, "read the folder and the designs again", hint 6 "reread";
    Redraw, "redraw", Program, "draw the whole screen again";
    Suspend, "suspend", Program, "suspend; fg in the shell comes back";
    Help, "help", Program, "this help", hint 5 "help";
    Quit, "quit", Program, "quit", hint 5 "quit";
}

impl Action {
    /// The table's row of this action.
    pub fn about(self) -> Option<&'static About> {
        ACTIONS.iter().find(|about| about.action == self)
    }
}
