package rasterlab.app.spline;

/** Which of the two labs the tab shows. */
public enum SplineMode {
    CURVE("curve"),
    FUNCTION("function");

    private final String code;

    SplineMode(String code) {
        this.code = code;
    }

    /** Lower-case name, as components and texts are named by. */
    public String code() {
        return code;
    }

    static SplineMode named(String code) {
        for (SplineMode mode : values()) if (mode.code.equals(code)) return mode;
        throw new IllegalArgumentException("no lab of splines is called '" + code + "'");
    }
}
