package rasterlab.engine.scene.obj;

/** A model or material file that cannot be read as one; the message begins with file and line. */
public final class BrokenFileException extends Exception {
    private static final long serialVersionUID = 1;

    private final String problem;

    /**
     * @param file its name, as the caller or the model's file gave it
     * @param line from 1, or 0 where the file as a whole is meant
     * @param problem what is wrong, and what is allowed
     */
    BrokenFileException(String file, int line, String problem) {
        super(line == 0 ? file + ": " + problem : file + ":" + line + ": " + problem);
        this.problem = problem;
    }

    /** The message without file and line. */
    public String problem() {
        return problem;
    }
}
