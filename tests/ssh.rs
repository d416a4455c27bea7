//! Over a real connection: a line that is cut takes neither the edits nor the machine with it.
//!
//! The server is OpenSSH's, on this machine, started by each test with keys and settings of its own. Where it is not installed or
//! cannot be started, the tests say so and are skipped.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod terminal_support;
mod tui_support;

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::os::unix::fs::DirBuilderExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use bevelscope::design::library::journals;
use portable_pty::CommandBuilder;
use terminal_support::{DESIGNS, FRAME, LONG, Terminal};

/// Shorter than anyone waits before logging in again: the program has a second for it, and the machine may be busy.
const GONE: Duration = Duration::from_secs(2);

/// A server with a library behind it; ended with what it holds.
struct Server {
    folder: tempfile::TempDir,
    daemon: Child,
    port: u16,
}

impl Drop for Server {
    fn drop(&mut self) {
        // none is left but where a test fails
        for explorer in self.explorers() {
            let _ = Command::new("kill").args(["-s", "KILL", &explorer.to_string()]).status();
        }
        let _ = self.daemon.kill();
        let _ = self.daemon.wait();
    }
}

/// Why there is no server.
type Missing = String;

/// A program in the folders of programs, or where Debian has those of the administrator.
fn installed(name: &str) -> Result<PathBuf, Missing> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::env::split_paths(&path).chain(["/usr/sbin".into(), "/usr/local/sbin".into()]);
    let found = folders.map(|folder| folder.join(name)).find(|path| path.is_file());
    found.ok_or_else(|| format!("{name} is not installed"))
}

/// Runs what says nothing where all is well.
fn run<T: AsRef<OsStr>>(program: &Path, arguments: &[T]) -> Result<(), Missing> {
    let output = Command::new(program).args(arguments).stdin(Stdio::null()).output();
    let output = output.map_err(|error| format!("{}: {error}", program.display()))?;
    let says = String::from_utf8_lossy(&output.stderr).into_owned();
    if output.status.success() { Ok(()) } else { Err(format!("{}: {says}", program.display())) }
}

fn read(log: &str) -> String {
    fs::read_to_string(log).unwrap_or_default()
}

impl Server {
    fn start() -> Result<Self, Missing> {
        let (daemon, keygen, client) = (installed("sshd")?, installed("ssh-keygen")?, installed("ssh")?);
        if !Path::new("/proc/self/stat").exists() {
            return Err("this system does not tell which processes live".into());
        }
        let folder = tempfile::tempdir().unwrap();
        let in_folder = |name: &str| folder.path().join(name).display().to_string();
        for key in ["host", "user"] {
            run(&keygen, &["-q", "-t", "ed25519", "-N", "", "-f", &in_folder(key)])?;
        }
        fs::copy(in_folder("user.pub"), in_folder("authorized_keys")).unwrap();
        fs::create_dir(in_folder("designs")).unwrap();
        fs::copy(format!("{DESIGNS}/overhung-elastic.toml"), in_folder("designs/a.toml")).unwrap();
        // where the server gives up its rights, as the superuser; anyone else cannot make it and needs it not
        let _ = fs::DirBuilder::new().mode(0o755).create("/run/sshd");
        let log = in_folder("log");
        // another process may be faster at taking a port that was free
        for _ in 0..5 {
            let port = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap().local_addr().unwrap().port();
            let settings = format!(
                "ListenAddress 127.0.0.1\nPort {port}\nHostKey {}\nAuthorizedKeysFile {}\nPidFile none\nStrictModes no\n\
                 UsePAM no\nPasswordAuthentication no\nKbdInteractiveAuthentication no\nPermitRootLogin yes\nPrintMotd no\n\
                 PrintLastLog no\n",
                in_folder("host"),
                in_folder("authorized_keys")
            );
            fs::write(in_folder("sshd_config"), settings).unwrap();
            // by its whole name, which it needs to start itself again
            let mut command = Command::new(&daemon);
            command.args(["-D", "-f", &in_folder("sshd_config"), "-E", &log]).stdin(Stdio::null());
            let mut daemon = command.spawn().map_err(|error| format!("{}: {error}", daemon.display()))?;
            let deadline = Instant::now() + LONG;
            while daemon.try_wait().unwrap().is_none() && Instant::now() < deadline {
                if TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_ok() {
                    let server = Self { folder, daemon, port };
                    let arguments = server.client("true");
                    let tried = run(&client, &arguments[1..]);
                    // an account may be locked, or have no shell
                    return tried.map(|()| server).map_err(|says| format!("nobody can log in: {says}{}", read(&log)));
                }
                thread::sleep(Duration::from_millis(20));
            }
            let _ = daemon.kill();
            let _ = daemon.wait();
        }
        Err(format!("sshd does not come up: {}", read(&log)))
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The client with nothing of the user's own: neither settings, keys nor known hosts.
    fn client(&self, remote: &str) -> Vec<String> {
        let (port, user) = (self.port.to_string(), self.path("user").display().to_string());
        let start = ["ssh", "-tt", "-F", "none", "-p", &port, "-i", &user, "-o", "BatchMode=yes"];
        let options =
            ["IdentitiesOnly=yes", "StrictHostKeyChecking=no", "UserKnownHostsFile=/dev/null", "LogLevel=ERROR"];
        let options = options.into_iter().flat_map(|option| ["-o", option]);
        start.into_iter().chain(options).chain(["127.0.0.1", remote]).map(str::to_owned).collect()
    }

    /// Logs in and opens the library.
    fn log_in(&self) -> Terminal {
        let command = CommandBuilder::from_argv(self.client(&self.remote()).into_iter().map(Into::into).collect());
        Terminal::run(command, &[("PATH", "/usr/local/bin:/usr/bin:/bin")])
    }

    /// What is run at the other end.
    fn remote(&self) -> String {
        let program = env!("CARGO_BIN_EXE_bevelscope");
        let (state, designs) = (self.path("state"), self.path("designs"));
        format!(
            "LC_ALL=C.UTF-8 XDG_STATE_HOME='{}' XDG_CONFIG_HOME='{}' exec '{program}' '{}'",
            state.display(),
            self.path("config").display(),
            designs.display()
        )
    }

    /// The explorers on the library, by their process numbers.
    fn explorers(&self) -> Vec<u32> {
        let ours = [env!("CARGO_BIN_EXE_bevelscope").to_owned(), self.path("designs").display().to_string()];
        processes().into_iter().filter(|process| process.arguments == ours).map(|process| process.number).collect()
    }

    /// The children of the server: each serves one connection.
    fn connections(&self) -> Vec<u32> {
        let server = self.daemon.id();
        processes().into_iter().filter(|process| process.parent == server).map(|process| process.number).collect()
    }
}

/// A process that lives.
#[derive(Debug)]
struct Process {
    number: u32,
    parent: u32,
    arguments: Vec<String>,
}

/// All of them, but those that have ended and were not waited for.
fn processes() -> Vec<Process> {
    let numbers = fs::read_dir("/proc").unwrap().filter_map(|entry| entry.unwrap().file_name().to_str()?.parse().ok());
    // one may end while it is looked at
    let look = |number: u32| {
        let stat = fs::read_to_string(format!("/proc/{number}/stat")).ok()?;
        let mut words = stat.rsplit(')').next()?.split_whitespace();
        let (state, parent) = (words.next()?, words.next()?.parse().ok()?);
        let arguments = fs::read(format!("/proc/{number}/cmdline")).ok()?;
        let arguments = String::from_utf8_lossy(&arguments).split_terminator('\0').map(str::to_owned).collect();
        (state != "Z").then_some(Process { number, parent, arguments })
    };
    numbers.filter_map(look).collect()
}

fn kill(process: u32) {
    assert!(Command::new("kill").args(["-s", "KILL", &process.to_string()]).status().unwrap().success());
}

/// How a connection ends.
enum Cut {
    /// The machine at this end.
    Client,
    /// The process of the server that serves this connection.
    Connection,
}

fn edits_outlive(cut: &Cut) {
    let server = match Server::start() {
        Ok(server) => server,
        Err(missing) => {
            // past the harness, which keeps to itself what a test prints that is well
            let _ = writeln!(std::io::stderr(), "skipped, nothing was tried over SSH: {missing}");
            return;
        }
    };
    let mut terminal = server.log_in();
    terminal.wait_for_text(FRAME);
    let [explorer] = server.explorers()[..] else { panic!("{:?}", server.explorers()) };
    terminal.press("e");
    terminal.wait_for_text("pinion segments");
    terminal.press("c36.5\r");
    terminal.wait_for_text("u: length of");
    terminal.press("S");
    terminal.wait_for_text("Save as a variant of a");
    terminal.press("\x15stiffer\r");
    terminal.wait_for_text("saved stiffer.toml, a variant of a.toml");
    let saved = fs::read_to_string(server.path("designs/stiffer.toml")).unwrap();
    assert!(saved.contains("length_mm = 36.5"));
    terminal.press("c20.25\r");
    terminal.wait_for_text("u: length of pinion segment 2");
    let recovery = server.path("state/bevelscope/recovery");
    // accepted is protected: within a second, and more here where the machine may be busy
    terminal.wait_until("in a journal", || {
        let found = journals(&recovery);
        found.iter().any(|found| found.journal.as_ref().is_ok_and(|journal| journal.text.contains("20.25")))
    });

    match cut {
        Cut::Client => kill(terminal.child.process_id().unwrap()),
        Cut::Connection => {
            // those of before may still be ending
            terminal.wait_until("the only connection", || server.connections().len() == 1);
            kill(server.connections()[0]);
        }
    }
    let deadline = Instant::now() + GONE;
    // also the shell that the server started it with
    while !server.explorers().is_empty() {
        assert!(Instant::now() < deadline, "of process {explorer} there is still {:?}", server.explorers());
        thread::sleep(Duration::from_millis(20));
    }
    terminal.wait(LONG);
    // a process that ends gives its command line back before its locks
    while journals(&recovery).iter().any(|found| found.is_alive) {
        assert!(Instant::now() < deadline, "the journals are still locked");
        thread::sleep(Duration::from_millis(20));
    }

    let mut again = server.log_in();
    again.wait_for_text("Unsaved edits of an earlier run");
    again.wait_for_text("stiffer");
    again.wait_for_text("19.0 → 20.25 mm");
    again.press("t");
    again.wait_for_text("u: recovered edits");
    again.wait_for("edited value in the table", |screen| {
        screen.contents().lines().any(|line| line.contains("segment 2") && line.contains("20.25"))
    });
    again.press("\x1b");
    again.wait_for("variant in the list", |screen| {
        screen.contents().contains("Designs") && screen.contents().lines().any(|line| line.contains("stiffer"))
    });
    // the file is as it was saved
    assert_eq!(fs::read_to_string(server.path("designs/stiffer.toml")).unwrap(), saved);
    again.press("\x03");
    again.wait_for_text("discard the edits and quit");
    again.press("d");
    assert!(again.wait(LONG).success());
    again.assert_restored();
}

#[test]
fn edits_outlive_a_client_that_is_killed() {
    edits_outlive(&Cut::Client);
}

#[test]
fn edits_outlive_a_server_process_that_is_killed() {
    edits_outlive(&Cut::Connection);
}
