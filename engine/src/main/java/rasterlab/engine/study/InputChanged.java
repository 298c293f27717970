package rasterlab.engine.study;

/** Thrown where a method wrote into what it was only given to read. */
public final class InputChanged extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    InputChanged() {
        super("it overwrote what it was given");
    }
}
