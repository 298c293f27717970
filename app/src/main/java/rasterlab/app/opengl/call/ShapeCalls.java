package rasterlab.app.opengl.call;

import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.GlShape;
import rasterlab.app.opengl.state.Setting;

/** The vertices of a shape between glBegin and glEnd. */
final class ShapeCalls {
    private final CallList calls;
    private final float alpha;

    /**
     * @param alpha of the vertices' colours
     */
    ShapeCalls(CallList calls, double alpha) {
        this.calls = calls;
        this.alpha = (float) alpha;
    }

    /** Sends the shape anew in each frame. */
    void direct(GlShape shape) {
        calls.of(Setting.SCENE).add(text(shape), () -> draw(shape));
        calls.free();
    }

    /** Calls a shape once into a display list, which each frame calls. */
    void listed(GlShape shape, String key) {
        calls.of(Setting.DISPLAY_LIST)
                .add(
                        "glNewList(%s, GL_COMPILE); %s; glEndList()"
                                .formatted(shape.name(), text(shape)),
                        objects -> objects.list(key, () -> draw(shape)));
        calls.add(
                "glCallList(" + shape.name() + ")",
                objects -> GL11.glCallList(objects.list(key, () -> draw(shape))));
        calls.free();
    }

    private static String text(GlShape shape) {
        return "glBegin(%s); %d × (glColor4f, glNormal3f, glTexCoord2f, glVertex3f); glEnd()"
                .formatted(shape.mode(), shape.indices().length);
    }

    private void draw(GlShape shape) {
        float[] xyz = shape.xyz();
        float[] n = shape.normals();
        float[] rgb = shape.rgb();
        float[] st = shape.st();
        GL11.glBegin(shape.mode().value());
        for (int v : shape.indices()) {
            GL11.glColor4f(rgb[3 * v], rgb[3 * v + 1], rgb[3 * v + 2], alpha);
            GL11.glNormal3f(n[3 * v], n[3 * v + 1], n[3 * v + 2]);
            GL11.glTexCoord2f(st[2 * v], st[2 * v + 1]);
            GL11.glVertex3f(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]);
        }
        GL11.glEnd();
    }
}
