package rasterlab.app.opengl.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.transform.GlMatrices;

/**
 * All that both OpenGL and the software pipeline need to draw a choice at one size.
 *
 * @param width of the picture in pixels, as height
 * @param texture none where it is switched off
 */
public record GlFrame(GlChoice choice, int width, int height, Optional<Texture> texture) {
    /** The colour of the background, 0xAARRGGBB. */
    public static final int BACKGROUND = 0xFF1E2430;

    /** The environment's colour, for GL_BLEND, 0xAARRGGBB. */
    public static final int ENVIRONMENT = 0xFFFFCC33;

    /** The share that the alpha test compares with. */
    public static final double ALPHA_REFERENCE = 0.5;

    /** Half the height that is seen at distance 1. */
    private static final double SPREAD = 0.32;

    /** Degrees by which the texture matrix may turn. */
    public static final double TURNED_TEXTURE = 30;

    public GlFrame {
        if (width < 1 || height < 1)
            throw new IllegalArgumentException(
                    "picture must have at least 1×1 pixel, got " + width + "×" + height);
    }

    public boolean perspective() {
        return choice.is(Setting.PROJECTION, "perspective");
    }

    /** left, right, bottom, top, near, far, as glFrustum and glOrtho take them. */
    public double[] volume() {
        String[] depths = choice.parts(Setting.NEAR_FAR);
        double near = Double.parseDouble(depths[0]);
        double far = Double.parseDouble(depths[1]);
        double up = SPREAD * (perspective() ? near : choice.distance());
        // The whole scene is seen in a narrow picture too.
        if (height > width) up *= (double) height / width;
        double right = up * width / height;
        return new double[] {-right, right, -up, up, near, far};
    }

    /** Eye to clip, for row points. */
    public Matrix4d projection() {
        double[] v = volume();
        return perspective()
                ? GlMatrices.frustum(v[0], v[1], v[2], v[3], v[4], v[5])
                : GlMatrices.ortho(v[0], v[1], v[2], v[3], v[4], v[5]);
    }

    /** World to eye, for row points: turned, tilted, moved away. */
    public Matrix4d modelView() {
        return new Matrix4d()
                .translate(0, 0, -choice.distance())
                .rotateX(Math.toRadians(choice.tilt()))
                .rotateY(Math.toRadians(choice.turn()));
    }

    /** Texture coordinates to others, for row points. */
    public Matrix4d textureMatrix() {
        var matrix = new Matrix4d();
        return switch (choice.get(Setting.TEXTURE_MATRIX)) {
            case "scale" -> matrix.scale(2, 2, 1);
            case "rotate" -> matrix.rotateZ(Math.toRadians(TURNED_TEXTURE));
            case "translate" -> matrix.translate(0.25, 0.25, 0);
            default -> matrix;
        };
    }

    /** The lights in their order; none where there is no lighting. */
    public List<GlLight> lights() {
        return lit() ? GlLights.of(choice) : List.of();
    }

    public boolean lit() {
        return !choice.is(Setting.LIGHTING, "color");
    }

    /** Whether the vertices' colours stand for the material's ambient and diffuse ones. */
    public boolean colorIsMaterial() {
        return choice.is(Setting.LIGHTING, "light-color");
    }

    public GlMaterial front() {
        return GlMaterial.named(choice.get(Setting.FRONT_MATERIAL));
    }

    public GlMaterial back() {
        return GlMaterial.named(choice.get(Setting.BACK_MATERIAL));
    }

    /** The shapes that turn with the scene, in drawing order. */
    public List<GlShape> shapes() {
        return GlShapes.of(choice);
    }

    /** The balls that show where lights stand; they do not turn with the scene. */
    public List<GlShape> lamps() {
        var lamps = new ArrayList<GlShape>();
        for (GlLight light : lights()) {
            if (light.directional()) continue;
            double[] at = light.position();
            double[] color = light.diffuse().clone();
            double most = Math.max(color[0], Math.max(color[1], color[2]));
            for (int c = 0; c < 3; c++) color[c] = most > 0 ? color[c] / most : 1;
            lamps.add(GlShapes.lamp(color, at[0], at[1], at[2]));
        }
        return List.copyOf(lamps);
    }

    /** x, y, width and height of the scissors' rectangle, from the bottom left. */
    public int[] scissors() {
        return new int[] {width / 4, height / 4, width - width / 2, height - height / 2};
    }
}
