package rasterlab.app.outcome;

/** A failure that one line explains to the user, with the exit code that goes with it. */
public final class Complaint extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final int exitCode;

    private Complaint(int exitCode, String message) {
        super(message);
        this.exitCode = exitCode;
    }

    /** A complaint about wrong input: names the place, the value and what is allowed. */
    public static Complaint badInput(String message) {
        return new Complaint(ExitCode.BAD_INPUT, message);
    }

    /** The method says that it cannot take this input. */
    public static Complaint refused(String message) {
        return new Complaint(ExitCode.REFUSED, message);
    }

    /** The method crashed, did not end, or its answer is over a limit. */
    public static Complaint gaveUp(String message) {
        return new Complaint(ExitCode.GAVE_UP, message);
    }

    public int exitCode() {
        return exitCode;
    }
}
