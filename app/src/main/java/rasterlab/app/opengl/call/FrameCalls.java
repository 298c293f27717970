package rasterlab.app.opengl.call;

import java.util.List;
import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlName;
import rasterlab.app.opengl.state.GlShape;
import rasterlab.app.opengl.state.Setting;

/** The calls of one frame, from the cleared picture to the last shape. */
public final class FrameCalls {
    private final GlFrame frame;
    private final GlChoice choice;
    private final CallList calls = new CallList();

    private FrameCalls(GlFrame frame) {
        this.frame = frame;
        choice = frame.choice();
    }

    public static List<GlCall> of(GlFrame frame) {
        var made = new FrameCalls(frame);
        made.begin();
        made.matrices();
        made.polygons();
        made.pixels();
        if (!frame.lamps().isEmpty()) {
            made.calls.free();
            for (GlShape lamp : frame.lamps()) new ShapeCalls(made.calls, 1).direct(lamp);
        }
        new LightCalls(frame, made.calls).add();
        made.turn();
        frame.texture().ifPresent(texture -> new TextureCalls(frame, made.calls).add(texture));
        made.shapes();
        made.calls.free().add("glPopAttrib()", () -> GL11.glPopAttrib());
        return made.calls.all();
    }

    private void begin() {
        int width = frame.width();
        int height = frame.height();
        calls.add(
                "glPushAttrib(GL_ALL_ATTRIB_BITS)",
                () -> GL11.glPushAttrib(GL11.GL_ALL_ATTRIB_BITS));
        calls.add(
                "glViewport(0, 0, " + width + ", " + height + ")",
                () -> GL11.glViewport(0, 0, width, height));
        double red = share(GlFrame.BACKGROUND, 16);
        double green = share(GlFrame.BACKGROUND, 8);
        double blue = share(GlFrame.BACKGROUND, 0);
        calls.add(
                "glClearColor(" + CallList.numbers(red, green, blue, 1) + ")",
                () -> GL11.glClearColor((float) red, (float) green, (float) blue, 1));
        if (choice.is(Setting.DEPTH_FUNC, "GL_GREATER"))
            calls.of(Setting.DEPTH_FUNC).add("glClearDepth(0)", () -> GL11.glClearDepth(0));
        calls.free()
                .add(
                        "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)",
                        () -> GL11.glClear(GL11.GL_COLOR_BUFFER_BIT | GL11.GL_DEPTH_BUFFER_BIT));
    }

    static double share(int argb, int shift) {
        return (argb >> shift & 255) / 255.0;
    }

    private void matrices() {
        double[] v = frame.volume();
        calls.of(Setting.PROJECTION).matrixMode(GlName.GL_PROJECTION);
        if (frame.perspective())
            calls.add(
                    "glFrustum(" + CallList.numbers(v) + ")",
                    () -> GL11.glFrustum(v[0], v[1], v[2], v[3], v[4], v[5]));
        else
            calls.add(
                    "glOrtho(" + CallList.numbers(v) + ")",
                    () -> GL11.glOrtho(v[0], v[1], v[2], v[3], v[4], v[5]));
        calls.free().matrixMode(GlName.GL_MODELVIEW);
        calls.translate(0, 0, -choice.distance());
    }

    private void polygons() {
        GlName mode = choice.named(Setting.POLYGON_MODE);
        calls.of(Setting.POLYGON_MODE)
                .add(
                        "glPolygonMode(GL_FRONT_AND_BACK, " + mode + ")",
                        () -> GL11.glPolygonMode(GL11.GL_FRONT_AND_BACK, mode.value()));
        GlName front = choice.named(Setting.FRONT_FACE);
        calls.of(Setting.FRONT_FACE)
                .add("glFrontFace(" + front + ")", () -> GL11.glFrontFace(front.value()));
        boolean culls = !choice.is(Setting.CULL_FACE, "off");
        calls.of(Setting.CULL_FACE).enable(GlName.GL_CULL_FACE, culls);
        if (!culls) return;
        GlName face = choice.named(Setting.CULL_FACE);
        calls.add("glCullFace(" + face + ")", () -> GL11.glCullFace(face.value()));
    }

    private void pixels() {
        calls.of(Setting.SCISSOR_TEST)
                .enable(GlName.GL_SCISSOR_TEST, choice.is(Setting.SCISSOR_TEST, "on"));
        if (choice.is(Setting.SCISSOR_TEST, "on")) {
            int[] s = frame.scissors();
            calls.add(
                    "glScissor(%d, %d, %d, %d)".formatted(s[0], s[1], s[2], s[3]),
                    () -> GL11.glScissor(s[0], s[1], s[2], s[3]));
        }
        depth();
        blending();
        calls.of(Setting.ALPHA_TEST)
                .enable(GlName.GL_ALPHA_TEST, !choice.is(Setting.ALPHA_TEST, "off"));
        if (choice.is(Setting.ALPHA_TEST, "off")) return;
        GlName function = choice.named(Setting.ALPHA_TEST);
        double least = GlFrame.ALPHA_REFERENCE;
        calls.add(
                "glAlphaFunc(" + function + ", " + CallList.numbers(least) + ")",
                () -> GL11.glAlphaFunc(function.value(), (float) least));
    }

    private void depth() {
        calls.of(Setting.DEPTH_TEST)
                .enable(GlName.GL_DEPTH_TEST, choice.is(Setting.DEPTH_TEST, "on"));
        GlName function = choice.named(Setting.DEPTH_FUNC);
        calls.of(Setting.DEPTH_FUNC)
                .add("glDepthFunc(" + function + ")", () -> GL11.glDepthFunc(function.value()));
        GlName writes = choice.named(Setting.DEPTH_MASK);
        calls.of(Setting.DEPTH_MASK)
                .add(
                        "glDepthMask(" + writes + ")",
                        () -> GL11.glDepthMask(writes == GlName.GL_TRUE));
    }

    private void blending() {
        boolean on = !choice.is(Setting.BLEND, "off");
        calls.of(Setting.BLEND).enable(GlName.GL_BLEND, on);
        if (!on) return;
        String[] factors = choice.parts(Setting.BLEND);
        GlName source = GlName.valueOf(factors[0]);
        GlName target = GlName.valueOf(factors[1]);
        calls.add(
                "glBlendFunc(" + source + ", " + target + ")",
                () -> GL11.glBlendFunc(source.value(), target.value()));
    }

    private void turn() {
        calls.free().rotate(choice.tilt(), 1, 0, 0);
        calls.rotate(choice.turn(), 0, 1, 0);
    }

    private void shapes() {
        boolean listed = choice.is(Setting.DISPLAY_LIST, "on");
        for (GlShape shape : frame.shapes()) {
            var added = new ShapeCalls(calls, choice.number(Setting.ALPHA));
            if (listed) added.listed(shape, key(shape));
            else added.direct(shape);
        }
    }

    /** The key of a shape: all that its calls depend on. */
    private String key(GlShape shape) {
        return shape.name()
                + " "
                + choice.get(Setting.COORDINATES)
                + " "
                + choice.get(Setting.ALPHA);
    }
}
