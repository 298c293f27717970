package rasterlab.app.coordinates.figure;

/**
 * The meaning of a mark, which decides how it looks.
 *
 * @param method whose colour it has, for {@link Role#METHOD}
 */
public record MarkInk(Role role, String method) {
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
    public static final MarkInk OBJECT = new MarkInk(Role.OBJECT, "");

    /** Where the object was before, or is to be. */
    public static final MarkInk GHOST = new MarkInk(Role.GHOST, "");

    /** Lines that help to see. */
    public static final MarkInk HELP = new MarkInk(Role.HELP, "");

    public static final MarkInk PLANE = new MarkInk(Role.PLANE, "");

    /** A plane that is seen from its side. */
    public static final MarkInk EDGE = new MarkInk(Role.EDGE, "");

    public static final MarkInk EYE = new MarkInk(Role.EYE, "");

    /** The ink of things that must not be drawn so. */
    public static final MarkInk WRONG = new MarkInk(Role.WRONG, "");

    /** The ink of the wrong result of a faulty method. */
    public static final MarkInk PRINTED = new MarkInk(Role.PRINTED, "");

    public static final MarkInk LEFT_EYE = new MarkInk(Role.LEFT_EYE, "");
    public static final MarkInk RIGHT_EYE = new MarkInk(Role.RIGHT_EYE, "");

    public static MarkInk method(String name) {
        return new MarkInk(Role.METHOD, name);
    }

    /** The ink of axis 0, 1 or 2. */
    public static MarkInk axis(int axis) {
        return new MarkInk(Role.values()[Role.AXIS_X.ordinal() + axis], "");
    }
}
