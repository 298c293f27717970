package rasterlab.tests.bench.pipeline;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.contract.LightSource;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.shape.Torus;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;

/**
 * A torus that fills about half of the picture, lit by one distant light with a highlight, as a
 * scene that a user draws and as OpenGL needs it.
 *
 * @param triangles of the torus, half of them seen from behind; an even number
 */
record TorusScene(int triangles, int width, int height) {
    static final int BACKGROUND = 0xFF202020;
    static final double AMBIENT = 0.2;

    private static final Torus TORUS = new Torus(1, 0.45);
    private static final SphericalView CAMERA = new SphericalView(0.4, 0.9, 3.6);
    private static final double PICTURE_SCALE = 200;
    private static final double NEAR = 1;
    private static final double FAR = 10;

    TorusScene {
        if (triangles < 18 || triangles % (2 * sides(triangles)) != 0)
            throw new IllegalArgumentException(
                    "triangles must be 2·rings·sides, of 3 sides at least, got " + triangles);
    }

    /** About half as many as rings. */
    private static int sides(int triangles) {
        int pairs = triangles / 2;
        int sides = Math.max(3, (int) Math.sqrt(pairs / 2.0));
        while (sides > 3 && pairs % sides != 0) sides--;
        return sides;
    }

    /** The direction to the light in the world, of length 1. */
    static double[] toLight() {
        double third = 1 / Math.sqrt(3);
        return new double[] {third, third, third};
    }

    private int rings() {
        return triangles / 2 / sides(triangles);
    }

    /** The picture as a user asks for it. */
    RenderRequest request(TorusLook look) {
        var mesh = TORUS.faces(rings(), sides(triangles));
        var scene =
                new Scene(
                        "torus",
                        mesh,
                        List.of(look.finish()),
                        new int[mesh.faceCount()],
                        light(),
                        BACKGROUND & 0xFFFFFF,
                        CAMERA,
                        PICTURE_SCALE);
        var usual =
                new RenderRequest(
                        scene,
                        Renderer.PIPELINE,
                        look.shading(),
                        Projection.PERSPECTIVE.code(),
                        CAMERA,
                        width,
                        height);
        return usual.with(usual.look().withTexture(look.texture()));
    }

    private static SceneLight light() {
        LightSource white = LightSource.white();
        double diffuse = 1 - AMBIENT;
        var sun =
                new LightSource(
                        white.ambient(),
                        new double[] {diffuse, diffuse, diffuse},
                        white.specular(),
                        white.attenuation(),
                        white.cone());
        double[] to = toLight();
        return new SceneLight(
                LightModel.openGl(Light.from(sun, to[0], to[1], to[2])).withLocalViewer(),
                Optional.empty());
    }

    /** The torus as triangles that share vertices. */
    TriangleMesh mesh() {
        return grid().mesh();
    }

    /** The torus with colours of its own, for the pipeline beside itself. */
    TriangleMesh colored() {
        return grid().colored();
    }

    private TorusGrid grid() {
        return new TorusGrid(TORUS, rings(), sides(triangles));
    }

    /** The torus, the pairs of triangles farthest from the eye first. */
    TriangleMesh farthestFirst() {
        return grid().farthestFirst(turned());
    }

    /** Moves the eye to the origin; the axes stay the world's. */
    Matrix4d toEye() {
        Vector3d eye = CAMERA.eye();
        return new Matrix4d().translation(-eye.x, -eye.y, -eye.z);
    }

    TriangleView view() {
        return new TriangleView(toEye(), toClip());
    }

    /**
     * The way from there to −w ≤ x, y, z ≤ w, with the middle of the picture where a user has it.
     */
    Matrix4d toClip() {
        var fit = PictureFit.of(width, height, PICTURE_SCALE);
        double size = 2 * fit.pixelsPerUnit() * CAMERA.rho();
        double right = (2 * fit.toPixelX(0) + 1) / width - 1;
        double up = 1 - (2 * fit.toPixelY(0) + 1) / height;
        double deep = FAR - NEAR;
        return new Matrix4d()
                .zero()
                .m00(size / width)
                .m20(right)
                .m11(size / height)
                .m21(up)
                .m22((FAR + NEAR) / deep)
                .m32(-2 * FAR * NEAR / deep)
                .m23(1)
                .mul(turned());
    }

    /** Turns the world's axes to right, up and forward. */
    private static Matrix4d turned() {
        var view = new ViewTransform(CAMERA, Projection.PERSPECTIVE);
        var turned = new Matrix4d();
        for (int axis = 0; axis < 3; axis++) {
            double origin = view.toEye(axis, 0, 0, 0);
            turned.set(0, axis, view.toEye(axis, 1, 0, 0) - origin);
            turned.set(1, axis, view.toEye(axis, 0, 1, 0) - origin);
            turned.set(2, axis, view.toEye(axis, 0, 0, 1) - origin);
        }
        return turned;
    }

    @Override
    public String toString() {
        return "torus of %,d triangles, %d×%d".formatted(triangles, width, height);
    }
}
