fn main() {
    println!("bevelscope");
}
