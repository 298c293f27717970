package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** A command of OpenGL that chooses, keeps or changes a matrix; and one that draws. */
public enum StackOp {
    MODELVIEW("glMatrixMode(GL_MODELVIEW)"),
    PROJECTION("glMatrixMode(GL_PROJECTION)"),
    TEXTURE("glMatrixMode(GL_TEXTURE)"),
    PUSH("glPushMatrix"),
    POP("glPopMatrix"),
    IDENTITY("glLoadIdentity"),
    TRANSLATE("glTranslated", "x", 2, "y", 0, "z", 0),
    ROTATE("glRotated", "degrees", 30, "x", 0, "y", 0, "z", 1),
    SCALE("glScaled", "x", 2, "y", 1, "z", 1),
    LOOK_AT(
            "gluLookAt",
            "eye x",
            8,
            "eye y",
            -10,
            "eye z",
            6,
            "center x",
            0,
            "center y",
            0,
            "center z",
            0,
            "up x",
            0,
            "up y",
            0,
            "up z",
            1),
    ORTHO("glOrtho", "left", -5, "right", 5, "bottom", -5, "top", 5, "near", 1, "far", 50),
    ORTHO_2D("gluOrtho2D", "left", -5, "right", 5, "bottom", -5, "top", 5),
    FRUSTUM("glFrustum", "left", -1, "right", 1, "bottom", -1, "top", 1, "near", 2, "far", 50),
    PERSPECTIVE("gluPerspective", "fovy", 40, "aspect", 1.5, "near", 1, "far", 50),
    LOAD("glLoadMatrixd"),
    MULT("glMultMatrixd"),
    CUBE("cube");

    private final String call;
    private final List<String> names;
    private final List<Double> first;

    /**
     * @param call as a program writes it
     * @param numbers name and first value of each
     */
    StackOp(String call, Object... numbers) {
        this.call = call;
        boolean cells = call.endsWith("Matrixd");
        var names = new ArrayList<String>();
        var first = new ArrayList<Double>();
        for (int i = 0; i < numbers.length; i += 2) {
            names.add((String) numbers[i]);
            first.add(((Number) numbers[i + 1]).doubleValue());
        }
        for (int i = 0; cells && i < 16; i++) {
            names.add((i / 4 + 1) + "," + (i % 4 + 1));
            first.add(i % 5 == 0 ? 1.0 : 0.0);
        }
        this.names = List.copyOf(names);
        this.first = List.copyOf(first);
    }

    String call() {
        return call;
    }

    /** The names of its numbers. */
    List<String> names() {
        return names;
    }

    /** The numbers that it is added with. */
    List<Double> first() {
        return first;
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static StackOp named(String code) {
        return Named.find("command", code, List.of(values()), StackOp::code);
    }
}
