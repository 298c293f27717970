package rasterlab.app.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.Scenes;
import rasterlab.engine.transform.SphericalView;

/** Renders a scene in software. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        description = {
            "Renders a scene and prints what was rendered as JSON.",
            "--out writes the picture, --diff compares it with another one; give at least one."
        },
        footer = {
            "",
            "Example: ./lab render vase --visibility painter --out vase.png",
            "         ./lab render vase --reference --diff vase.png"
        })
final class RenderCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(
            index = "0",
            paramLabel = "SCENE",
            description = "${COMPLETION-CANDIDATES}",
            completionCandidates = EngineNames.OfScenes.class)
    private String sceneName;

    @Option(
            names = "--visibility",
            paramLabel = "METHOD",
            description = "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfVisibilities.class,
            defaultValue = "zfloat")
    private String visibility;

    @Option(
            names = "--shading",
            paramLabel = "METHOD",
            description = "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfShadings.class,
            defaultValue = "flat")
    private String shading;

    @Option(
            names = "--projection",
            paramLabel = "NAME",
            description = "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfProjections.class,
            defaultValue = "perspective")
    private String projection;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "in pixels, 1x1 to 8192x8192; default: ${DEFAULT-VALUE}",
            defaultValue = "800x600",
            converter = PictureSize.Reader.class)
    private PictureSize size;

    @Option(
            names = "--camera",
            paramLabel = "THETA,PHI,RHO",
            description =
                    "eye in spherical coordinates, radians (0.25pi works too); default: the scene's",
            converter = CameraOption.class)
    private SphericalView camera;

    @Option(
            names = "--zoom",
            paramLabel = "FACTOR",
            description = "the scene's size in the picture, times this; default: ${DEFAULT-VALUE}",
            defaultValue = "1")
    private double zoom;

    @Option(names = "--outline", description = "draws the faces' edges; painters only")
    private boolean outline;

    @Option(names = "--reference", description = "the exact picture, whatever --visibility says")
    private boolean reference;

    @Option(names = "--diff", paramLabel = "OTHER.png", description = "counts the wrong pixels")
    private Path other;

    @Option(names = "--out", paramLabel = "FILE.png", description = "writes the picture")
    private Path out;

    RenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        RenderRequest request = request();
        if (out == null && other == null)
            throw Complaint.badInput(
                    "nothing to do; give --out FILE.png, --diff OTHER.png or both");
        if (out != null) requirePng(out);
        Optional<BufferedImage> expected =
                Optional.ofNullable(other)
                        .map(file -> PngFile.read(file, request.width(), request.height()));
        long start = System.nanoTime();
        Raster picture = drawn(request);
        double milliseconds = (System.nanoTime() - start) / 1e6;
        Optional<PictureDifference> difference =
                expected.map(image -> PictureDifference.of(copied(image), picture));
        if (out != null) WholeFile.write(out, PngFile.bytes(picture.image()));
        new RenderReport(request, milliseconds, out, other, difference).write(console.out());
        return ExitCode.DONE;
    }

    private static Raster drawn(RenderRequest request) {
        try {
            return new Renderer().render(request, Thread.currentThread()::isInterrupted);
        } catch (IllegalArgumentException refusal) {
            throw Complaint.refused(request.visibility() + " refuses: " + refusal.getMessage());
        }
    }

    private RenderRequest request() {
        try {
            Scene scene = Scenes.named(sceneName).zoomed(zoom);
            return new RenderRequest(
                    scene,
                    reference ? Renderer.REFERENCE : visibility,
                    shading,
                    projection,
                    camera == null ? scene.defaultCamera() : camera,
                    size.width(),
                    size.height(),
                    outline);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private static void requirePng(Path file) {
        if (!file.toString().toLowerCase(Locale.ROOT).endsWith(".png"))
            throw Complaint.badInput(file + ": unknown extension; allowed is .png");
        WholeFile.requireWritable(file);
    }

    private static Raster copied(BufferedImage image) {
        var raster = new Raster(image.getWidth(), image.getHeight());
        image.getRGB(0, 0, image.getWidth(), image.getHeight(), raster.argb(), 0, image.getWidth());
        return raster;
    }
}
