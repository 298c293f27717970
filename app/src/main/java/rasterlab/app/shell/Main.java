package rasterlab.app.shell;

/** The desktop lab and its command line. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        System.exit(0);
    }
}
