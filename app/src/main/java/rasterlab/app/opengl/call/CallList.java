package rasterlab.app.opengl.call;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.GlName;
import rasterlab.app.opengl.state.Setting;

/** Calls in the making, each with its text and its action side by side. */
final class CallList {
    private final List<GlCall> calls = new ArrayList<>();
    private Optional<Setting> setting = Optional.empty();

    /** The next calls set this state. */
    CallList of(Setting next) {
        setting = Optional.of(next);
        return this;
    }

    /** The next calls are nobody's. */
    CallList free() {
        setting = Optional.empty();
        return this;
    }

    List<GlCall> all() {
        return List.copyOf(calls);
    }

    void add(String text, Consumer<GlObjects> action) {
        calls.add(new GlCall(setting, text, action));
    }

    void add(String text, Runnable action) {
        add(text, objects -> action.run());
    }

    void enable(GlName name, boolean on) {
        if (on) add("glEnable(" + name + ")", () -> GL11.glEnable(name.value()));
        else add("glDisable(" + name + ")", () -> GL11.glDisable(name.value()));
    }

    void matrixMode(GlName mode) {
        add("glMatrixMode(" + mode + ")", () -> GL11.glMatrixMode(mode.value()));
        add("glLoadIdentity()", () -> GL11.glLoadIdentity());
    }

    void translate(double x, double y, double z) {
        add("glTranslated(%s)".formatted(numbers(x, y, z)), () -> GL11.glTranslated(x, y, z));
    }

    void rotate(double degrees, double x, double y, double z) {
        add(
                "glRotated(%s)".formatted(numbers(degrees, x, y, z)),
                () -> GL11.glRotated(degrees, x, y, z));
    }

    void light(int index, GlName what, double... values) {
        int light = GL11.GL_LIGHT0 + index;
        String start = "glLightf%s(GL_LIGHT%d, %s, ";
        if (values.length == 1)
            add(
                    start.formatted("", index, what) + numbers(values) + ")",
                    () -> GL11.glLightf(light, what.value(), (float) values[0]));
        else
            add(
                    start.formatted("v", index, what) + braces(values) + ")",
                    () -> GL11.glLightfv(light, what.value(), fourFloats(values)));
    }

    void lightModel(GlName what, double... values) {
        add(
                "glLightModelfv(" + what + ", " + braces(values) + ")",
                () -> GL11.glLightModelfv(what.value(), floats(values)));
    }

    void lightModel(GlName what, GlName value) {
        add(
                "glLightModeli(" + what + ", " + value + ")",
                () -> GL11.glLightModeli(what.value(), value.value()));
    }

    void material(GlName face, GlName what, double... values) {
        String start = "glMaterialf%s(" + face + ", " + what + ", ";
        if (values.length == 1)
            add(
                    start.formatted("") + numbers(values) + ")",
                    () -> GL11.glMaterialf(face.value(), what.value(), (float) values[0]));
        else
            add(
                    start.formatted("v") + braces(values) + ")",
                    () -> GL11.glMaterialfv(face.value(), what.value(), floats(values)));
    }

    void textureParameter(GlName what, GlName value) {
        add(
                "glTexParameteri(GL_TEXTURE_2D, " + what + ", " + value + ")",
                () -> GL11.glTexParameteri(GL11.GL_TEXTURE_2D, what.value(), value.value()));
    }

    static String numbers(double... values) {
        return Arrays.stream(values).mapToObj(CallList::number).collect(Collectors.joining(", "));
    }

    private static String braces(double... values) {
        return "{" + numbers(values) + "}";
    }

    /** The number with at most six digits, without a point where none is needed. */
    private static String number(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e9)
            return Long.toString(Math.round(value));
        return String.format(Locale.ROOT, "%.6g", value).replaceAll("0+$", "");
    }

    /** The binding wants room for four, also for the three of a direction. */
    private static float[] fourFloats(double[] values) {
        return Arrays.copyOf(floats(values), 4);
    }

    private static float[] floats(double[] values) {
        float[] copy = new float[values.length];
        for (int i = 0; i < values.length; i++) copy[i] = (float) values[i];
        return copy;
    }
}
