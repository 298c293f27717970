package rasterlab.engine.study;

/**
 * A method that runs elsewhere gave no answer. A lab shows its words in the place of a refusal; a
 * study takes its own kind of verdict.
 */
public final class NoAnswer extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    private final Verdict.Kind kind;

    /**
     * @param kind the verdict on the method
     * @param said one English sentence for whoever wrote the method
     */
    public NoAnswer(Verdict.Kind kind, String said) {
        super(said);
        this.kind = kind;
    }

    public Verdict.Kind kind() {
        return kind;
    }
}
