package rasterlab.tests.bench.pipeline;

import java.awt.AlphaComposite;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.joml.Vector4d;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.scene.catalogue.Scenes;

/**
 * The measurements that need no OpenGL: Java2D, the memory's limit, and the pipeline beside itself.
 */
final class OwnBench {
    private static final TorusScene SCENE = new TorusScene(100_000, 1280, 720);

    /** Faces round the torus that the page of the course draws: 10,000 or so in all. */
    private static final int DETAIL = 140;

    private final InterleavedTimes.Length length;

    OwnBench(InterleavedTimes.Length length) {
        this.length = length;
    }

    /** Two fills of plain arrays are what memory allows; the goal is 1.1 times their time. */
    Row clear(TrianglePipeline pipeline) {
        var nothing = TriangleMesh.of(new float[0], new float[0], new float[0], new int[0]);
        var view = SCENE.view();
        var surface = new Surface.Flat(VertexColors.own());
        var out = new DepthRaster(1920, 1080);
        int[] argb = new int[1920 * 1080];
        float[] depth = new float[1920 * 1080];
        var times =
                new InterleavedTimes(
                        length.times(5),
                        () -> pipeline.drawOn(1, nothing, view, surface, out, () -> false),
                        () -> {
                            Arrays.fill(argb, 1);
                            Arrays.fill(depth, 1f);
                        });
        return new Row(
                "colour and depth clear of 1920×1080",
                times.text(0),
                "two Arrays.fill " + times.text(1),
                times.ratio(1, 0),
                1 / 1.1,
                words -> "");
    }

    /** Times the way from the finished picture onto the one that a window shows. */
    Row present() {
        var picture = new Raster(1920, 1080);
        var shown = new BufferedImage(1920, 1080, BufferedImage.TYPE_INT_RGB);
        int[] copy = new int[1920 * 1080];
        var graphics = shown.createGraphics();
        graphics.setComposite(AlphaComposite.Src);
        var times =
                new InterleavedTimes(
                        length.times(5),
                        () -> graphics.drawImage(picture.image(), 0, 0, null),
                        () -> System.arraycopy(picture.argb(), 0, copy, 0, copy.length));
        graphics.dispose();
        return new Row(
                "present a frame of 1920×1080",
                times.text(0),
                "System.arraycopy " + times.text(1),
                times.ratio(1, 0),
                1 / 1.1,
                words -> "AlphaComposite.Src");
    }

    /** The time that only writing the same pixels, colour and depth, would take after the clear. */
    Row memory(TrianglePipeline pipeline) {
        var mesh = SCENE.colored();
        var view = SCENE.view();
        var surface = new Surface.Smooth(VertexColors.own());
        var out = new DepthRaster(SCENE.width(), SCENE.height());
        int cells = SCENE.width() * SCENE.height();
        int[] argb = new int[cells];
        float[] depth = new float[cells];
        var times =
                new InterleavedTimes(
                        length,
                        () -> pipeline.drawOn(1, mesh, view, surface, out, () -> false),
                        () -> {
                            Arrays.fill(argb, 1);
                            Arrays.fill(depth, 1f);
                            Arrays.fill(argb, cells / 3, 2 * cells / 3, 2);
                            Arrays.fill(depth, cells / 3, 2 * cells / 3, 0.5f);
                        });
        return new Row(
                SCENE + ", Gouraud, beside the memory limit",
                times.text(0),
                "the same bytes by Arrays.fill " + times.text(1),
                times.ratio(1, 0),
                0,
                words -> "");
    }

    Row threads(TrianglePipeline pipeline) {
        var mesh = SCENE.colored();
        var view = SCENE.view();
        var surface = new Surface.Smooth(VertexColors.own());
        var out = new Raster(SCENE.width(), SCENE.height());
        var alone = new Raster(SCENE.width(), SCENE.height());
        int cores = Runtime.getRuntime().availableProcessors();
        try (var one = new TrianglePipeline(1)) {
            var times =
                    new InterleavedTimes(
                            length,
                            () -> pipeline.drawOn(1, mesh, view, surface, out, () -> false),
                            () -> one.drawOn(1, mesh, view, surface, alone, () -> false));
            boolean same = Arrays.equals(out.argb(), alone.argb());
            return new Row(
                    SCENE + ", threads 1 → " + cores,
                    times.text(0),
                    "one thread " + times.text(1),
                    times.ratio(1, 0),
                    cores == 2 ? 1.85 : 0,
                    words -> words.text(same ? "note.same" : "note.differ"));
        }
    }

    /** Times the page of the course beside the fast pipeline, both as a user's picture is made. */
    Row page() {
        Scene scene = Scenes.named("torus", DETAIL);
        var fast = request(scene, Renderer.PIPELINE);
        var plain = request(scene, Renderer.PLAIN);
        var out = new Raster(SCENE.width(), SCENE.height());
        var read = new Raster(SCENE.width(), SCENE.height());
        try (var renderer = new Renderer()) {
            var times =
                    new InterleavedTimes(
                            length,
                            () -> renderer.render(fast, out, () -> false),
                            () -> renderer.render(plain, read, () -> false));
            return new Row(
                    "torus of %,d faces, %d×%d, Gouraud"
                            .formatted(scene.mesh().faceCount(), out.width(), out.height()),
                    times.text(0),
                    "the page of the course " + times.text(1),
                    times.ratio(1, 0),
                    0,
                    Difference.of(out.argb(), read.argb())::text);
        }
    }

    private static RenderRequest request(Scene scene, String visibility) {
        return new RenderRequest(
                scene,
                visibility,
                "gouraud",
                "perspective",
                scene.defaultCamera(),
                SCENE.width(),
                SCENE.height());
    }

    /** Java2D gets the corners on the picture and no depth: it does a part of the work only. */
    Row java2d(TrianglePipeline pipeline) {
        var mesh = SCENE.colored();
        var view = SCENE.view();
        var surface = new Surface.Smooth(VertexColors.own());
        var out = new Raster(SCENE.width(), SCENE.height());
        int[][] xy = corners(mesh);
        var graphics = new Raster(SCENE.width(), SCENE.height()).image().createGraphics();
        graphics.setColor(Color.ORANGE);
        int[] x = new int[3];
        int[] y = new int[3];
        var times =
                new InterleavedTimes(
                        length,
                        () -> pipeline.drawOn(1, mesh, view, surface, out, () -> false),
                        () -> {
                            graphics.clearRect(0, 0, SCENE.width(), SCENE.height());
                            int[] corner = mesh.triangles();
                            for (int t = 0; t < corner.length; t += 3) {
                                for (int k = 0; k < 3; k++) {
                                    x[k] = xy[0][corner[t + k]];
                                    y[k] = xy[1][corner[t + k]];
                                }
                                long area =
                                        (long) (x[1] - x[0]) * (y[2] - y[0])
                                                - (long) (x[2] - x[0]) * (y[1] - y[0]);
                                if (area < 0) graphics.fillPolygon(x, y, 3);
                            }
                        });
        return new Row(
                SCENE + ", Gouraud",
                times.text(0),
                "Java2D, one colour, no depth " + times.text(1),
                times.ratio(1, 0),
                0,
                words -> "");
    }

    private static int[][] corners(TriangleMesh mesh) {
        var whole = SCENE.toClip().mul(SCENE.toEye());
        int[][] xy = new int[2][mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            var clip =
                    new Vector4d(
                                    mesh.values(VertexQuantity.X)[v],
                                    mesh.values(VertexQuantity.Y)[v],
                                    mesh.values(VertexQuantity.Z)[v],
                                    1)
                            .mul(whole);
            xy[0][v] = (int) Math.rint((clip.x / clip.w + 1) * SCENE.width() / 2);
            xy[1][v] = (int) Math.rint((1 - clip.y / clip.w) * SCENE.height() / 2);
        }
        return xy;
    }
}
