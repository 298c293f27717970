package rasterlab.app.coordinates.figure;

/**
 * What a mark stands for, which decides how it looks.
 *
 * @param method whose colour it has, for {@link Role#METHOD}
 */
public record Ink(Role role, String method) {
    /** Kinds of marks, each told apart without its colour too. */
    public enum Role {
        OBJECT,
        GHOST,
        HELP,
        AXIS_X,
        AXIS_Y,
        AXIS_Z,
        PLANE,
        EDGE,
        EYE,
        WRONG,
        PRINTED,
        LEFT_EYE,
        RIGHT_EYE,
        METHOD
    }

    /** The object that is looked at. */
    public static final Ink OBJECT = new Ink(Role.OBJECT, "");

    /** Where the object was before, or is to be. */
    public static final Ink GHOST = new Ink(Role.GHOST, "");

    /** Lines that help to see. */
    public static final Ink HELP = new Ink(Role.HELP, "");

    public static final Ink PLANE = new Ink(Role.PLANE, "");

    /** A plane that is seen from its side. */
    public static final Ink EDGE = new Ink(Role.EDGE, "");

    public static final Ink EYE = new Ink(Role.EYE, "");

    /** What must not be drawn so. */
    public static final Ink WRONG = new Ink(Role.WRONG, "");

    /** What a faulty method made instead of the right thing. */
    public static final Ink PRINTED = new Ink(Role.PRINTED, "");

    public static final Ink LEFT_EYE = new Ink(Role.LEFT_EYE, "");
    public static final Ink RIGHT_EYE = new Ink(Role.RIGHT_EYE, "");

    public static Ink method(String name) {
        return new Ink(Role.METHOD, name);
    }

    /** The ink of axis 0, 1 or 2. */
    public static Ink axis(int axis) {
        return new Ink(Role.values()[Role.AXIS_X.ordinal() + axis], "");
    }
}
