package rasterlab.app.cli.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.model.EmptyPicture;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.FileLevels;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.plan.CountedWork;
import rasterlab.engine.pipeline.Choice;
import rasterlab.engine.pipeline.DrawnDepths;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.StageTimes;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.exercises.scene.SceneSetting;

/** Renders a scene in software. */
@Command(
        name = "render",
        abbreviateSynopsis = true,
        mixinStandardHelpOptions = true,
        description = {
            "Renders a scene and prints what was rendered as JSON.",
            "--out writes the picture, --diff compares it with another one; give at least one.",
            "The answer counts the work of each stage; beside it stand what the count costs, as predicted by"
                    + " measured prices, and what the planner predicts before it draws: in number,"
                    + " milliseconds and share."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the scene was rendered",
            "2:an argument, the scene or the picture of --diff is wrong, or a file cannot be written",
            "3:the method refuses this scene"
        },
        footer = {
            "",
            "Example: ./lab render vase --visibility painter --out vase.png",
            "         ./lab render vase --reference --diff vase.png",
            "         ./lab render torus --clip-plane 1,0,0,0 --out half.png",
            "         ./lab render torus --tolerance 0.5 --levels 4 --out least.png",
            "         ./lab render vase --shading auto --levels 3 --out shaded.png"
        })
public final class RenderCommand implements Callable<Integer> {
    /** Milliseconds for which stages are measured, if two rounds take less. */
    private static final double STAGES_BUDGET = 500;

    private final Console console;

    @Mixin private SceneArgument shown;

    @Option(
            names = "--visibility",
            paramLabel = "METHOD",
            description = {
                "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE},"
                        + " the cheapest whose picture is exact: convex or painter where that is proved,"
                        + " zfloat, and bsp where faces share a plane or glass crosses.",
                "raycast-surface draws the curved surface itself instead of the faces that stand for it,"
                        + " with --shading phong or auto"
            },
            completionCandidates = EngineNames.OfVisibilities.class,
            defaultValue = "auto")
    private String visibility;

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
                    "eye in spherical coordinates, radians from -1e6 to 1e6 (0.25pi works too), RHO from"
                            + " 0.001 to 1e6; default: the scene's",
            converter = CameraOption.class)
    private SphericalView camera;

    @Option(
            names = "--zoom",
            paramLabel = "FACTOR",
            description =
                    "scales the scene in the picture by this factor; default: ${DEFAULT-VALUE}",
            defaultValue = "1")
    private double zoom;

    @Option(
            names = "--near",
            paramLabel = "N",
            description =
                    "near clipping plane, in world units along the line of sight; none: no near plane",
            converter = DepthOption.class)
    private DepthOption.Limit near;

    @Option(
            names = "--far",
            paramLabel = "F",
            description = "far clipping plane, in world units; none: no far plane",
            converter = DepthOption.class)
    private DepthOption.Limit far;

    @Mixin private LookOptions look;

    @Mixin private TextureOptions texture;

    @Mixin private LeastPicture least;

    @Option(names = "--reference", description = "the exact picture, whatever --visibility says")
    private boolean reference;

    @Option(names = "--diff", paramLabel = "OTHER.png", description = "counts the wrong pixels")
    private Path other;

    @Option(
            names = "--errors",
            description = "counts the pixels of flat and Gouraud shading that differ from Phong's")
    private boolean errors;

    @Option(
            names = "--stages",
            description =
                    "measures what each stage takes on one thread, beside its count and its predicted"
                            + " share: draws the picture again and again, each time without one"
                            + " stage more")
    private boolean stages;

    @Option(names = "--out", paramLabel = "FILE.png", description = "writes the picture")
    private Path out;

    public RenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        RenderRequest asked = request();
        if (out == null && other == null && !errors && !stages)
            throw Complaint.badInput(
                    "nothing to do; give --out FILE.png, --diff OTHER.png, --errors or --stages");
        if (errors) requireErrors(asked.look());
        if (stages) requireStages(asked);
        if (out != null) requirePng(out);
        Optional<Plan> plan = least.plan(asked);
        Optional<Choice> shading = least.shading(asked);
        RenderRequest request = plan.map(Plan::least).orElse(shaded(asked, shading));
        RenderMemory.require(request, (other == null ? 0 : 3) + (errors || stages ? 3 : 0));
        Optional<BufferedImage> expected =
                Optional.ofNullable(other)
                        .map(file -> PngFile.read(file, request.width(), request.height()));
        var progress = new RenderProgress(console);
        long start = System.nanoTime();
        var picture = new Raster(request.width(), request.height());
        Optional<VisibilityWork> work = draw(request, picture, progress);
        double milliseconds = (System.nanoTime() - start) / 1e6;
        if (shown.isModel() && EmptyPicture.is(picture, request.scene().backgroundRgb()))
            shown.tellEmpty(console);
        Optional<PictureDifference> difference =
                expected.map(image -> PictureDifference.of(copied(image), picture));
        if (out != null) WholeFile.write(out, PngFile.bytes(picture.image()));
        Optional<ShadingErrors> shadings =
                errors ? Optional.of(ShadingErrors.of(request, progress)) : Optional.empty();
        Optional<CountedWork> counted = CountedWork.of(request, plan, progress);
        Optional<StageTimes> times =
                stages
                        ? Optional.of(StageTimes.of(request, STAGES_BUDGET, progress))
                        : Optional.empty();
        new RenderReport(
                        request,
                        plan,
                        shading,
                        milliseconds,
                        work,
                        counted,
                        times,
                        out,
                        other,
                        difference,
                        shadings)
                .write(console.out());
        return ExitCode.DONE;
    }

    private static RenderRequest shaded(RenderRequest asked, Optional<Choice> shading) {
        return shading.map(Choice::chosen)
                .map(ShadingMethod::named)
                .map(method -> asked.with(asked.look().withShading(method)))
                .orElse(asked);
    }

    private static Optional<VisibilityWork> draw(
            RenderRequest request, Raster picture, BooleanSupplier cancelled) {
        try (var renderer = new Renderer()) {
            return renderer.render(request, picture, cancelled);
        } catch (IllegalArgumentException refusal) {
            throw Complaint.refused(request.visibility() + " refuses: " + refusal.getMessage());
        }
    }

    private RenderRequest request() {
        try {
            ShownScene opened = shown.open(console);
            requireZoom();
            look.requireFaces(opened, texture.given());
            double scale = opened.option("--zoom", zoom, SceneSetting.ZOOM);
            Scene scene = texture.laid(opened, opened.scene().zoomed(scale), look.texture(opened));
            SphericalView eye = camera == null ? scene.defaultCamera() : camera;
            Projection chosen =
                    opened.option(
                            "--projection", Projection.named(projection), SceneSetting.PROJECTION);
            String method = opened.option("--visibility", visibility, SceneSetting.VISIBILITY);
            return new RenderRequest(
                    scene,
                    eye,
                    chosen,
                    depths(opened, chosen, eye.rho()),
                    size.width(),
                    size.height(),
                    look.look(opened, reference ? Renderer.REFERENCE : method, chosen, eye.rho()));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private void requireZoom() {
        double most = SceneSetting.MOST_ZOOM;
        if (!(zoom >= 1 / most && zoom <= most))
            throw new IllegalArgumentException(
                    "--zoom must be from %s to %s, got %s".formatted(1 / most, most, zoom));
    }

    private DrawnDepths depths(ShownScene opened, Projection chosen, double rho) {
        DrawnDepths all = DrawnDepths.all(chosen, rho);
        double from = limit(opened, near, SceneSetting.NEAR).orElse(all.near());
        double to = limit(opened, far, SceneSetting.FAR).orElse(all.far());
        Optional<SceneSetting<Double>> ofNear = opened.ofFile(near, SceneSetting.NEAR);
        Optional<SceneSetting<Double>> ofFar = opened.ofFile(far, SceneSetting.FAR);
        return opened.placed(
                ofNear,
                () -> {
                    DrawnDepths drawn = opened.placed(ofFar, () -> drawn(from, to));
                    requireOfOption(drawn, chosen, rho);
                    return drawn;
                });
    }

    /** The depths; a refusal names the option that a wrong one was given by. */
    private DrawnDepths drawn(double from, double to) {
        if (near != null && !(from < to))
            throw new IllegalArgumentException(
                    "--near must be below %s %s, got %s"
                            .formatted(far == null ? "far" : "--far", to, from));
        if (far != null && !(from < to))
            throw new IllegalArgumentException(
                    "--far must be above near %s, got %s".formatted(from, to));
        return new DrawnDepths(from, to);
    }

    private void requireOfOption(DrawnDepths drawn, Projection chosen, double rho) {
        try {
            drawn.require(chosen, rho);
        } catch (IllegalArgumentException refusal) {
            if (near == null) throw refusal;
            throw new IllegalArgumentException("--" + refusal.getMessage(), refusal);
        }
    }

    private static Optional<Double> limit(
            ShownScene opened, DepthOption.Limit given, SceneSetting<Double> setting) {
        return given == null ? opened.settings().get(setting) : given.units();
    }

    private static void requireErrors(Look look) {
        if (look.shading() == ShadingMethod.WIRE || look.visibility().equals(Renderer.SURFACES))
            throw Complaint.badInput(
                    "--errors needs faces to shade; neither --shading wire nor --visibility "
                            + Renderer.SURFACES
                            + " has any");
    }

    private static void requireStages(RenderRequest asked) {
        if (!CountedWork.drawsFaces(asked))
            throw Complaint.badInput(
                    "--stages needs faces that a method draws for one eye; --reference, --stereo,"
                            + " --shading wire and --visibility "
                            + Renderer.SURFACES
                            + " have none");
    }

    private static void requirePng(Path file) {
        if (!file.toString().toLowerCase(Locale.ROOT).endsWith(".png"))
            throw Complaint.badInput(file + ": unknown extension; allowed is .png");
        WholeFile.requireWritable(file);
    }

    private static Raster copied(BufferedImage image) {
        var raster = new Raster(image.getWidth(), image.getHeight());
        for (int y = 0; y < image.getHeight(); y++)
            FileLevels.row(image, y, raster.argb(), y * image.getWidth());
        return raster;
    }
}
