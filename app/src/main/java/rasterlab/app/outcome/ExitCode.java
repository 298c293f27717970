package rasterlab.app.outcome;

/** The meaning of the exit codes; every command's help lists the ones it uses. */
public final class ExitCode {
    public static final int DONE = 0;

    /** The command did its work and found something wrong: a verdict, a submission, a part. */
    public static final int FOUND_WRONG = 1;

    public static final int BAD_INPUT = 2;

    /** The method said that it cannot take this input. */
    public static final int REFUSED = 3;

    /**
     * There is no answer: the method crashed, did not end, or its answer is over a limit; or no
     * server takes what is handed in.
     */
    public static final int GAVE_UP = 4;

    /** A fault of ours; details are in the log that the message names. */
    public static final int INTERNAL = 70;

    /** The work was done, but its output could not be written: a full disk. EX_IOERR, sysexits. */
    public static final int NOT_WRITTEN = 74;

    private ExitCode() {}
}
