package rasterlab.app.cli.render;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.PrettyJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.plan.PlanReport;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.plan.BruteForce;
import rasterlab.engine.plan.Combination;
import rasterlab.engine.plan.CostStudy;
import rasterlab.engine.plan.PlanPath;
import rasterlab.engine.plan.PlanTrial;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.SphericalView;
import rasterlab.exercises.scene.SceneSetting;

/** Finds the least model of a scene that is enough. */
@Command(
        name = "plan",
        abbreviateSynopsis = true,
        mixinStandardHelpOptions = true,
        description = {
            "Finds the least that must be drawn of a scene to stay within a tolerance.",
            "It is held against the full pipeline: all faces by depth, the light formula at each pixel, mipmaps.",
            "A pixel is within the tolerance if each channel is at most L levels beyond those that the other"
                    + " picture has within PX pixels of it, both ways.",
            "Prints what is left out, by which proof or bound, and error and cost, predicted and measured."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the least was found",
            "2:an argument or the scene is wrong, or a file cannot be written"
        },
        footer = {
            "",
            "Example: ./lab plan torus --tolerance 0.5 --levels 4",
            "         ./lab plan vase --tolerance 1 --levels 8 --prove --json"
        })
public final class PlanCommand implements Callable<Integer> {
    /** Rounds of drawing the full picture and the least one in turns. */
    private static final int ROUNDS = 15;

    /** Pictures of the camera's path along which deciding is measured. */
    private static final int PICTURES = 100;

    private final Console console;

    @Mixin private SceneArgument shown;

    @Option(
            names = "--tolerance",
            paramLabel = "PX",
            description =
                    "how far things may be out of place, in pixels, above 0 to 64; default:"
                            + " ${DEFAULT-VALUE}",
            defaultValue = "0.5",
            converter = ToleranceOption.PixelsReader.class)
    private double pixels;

    @Option(
            names = "--levels",
            paramLabel = "L",
            description =
                    "how far a channel may be off, in levels of 0 to 255; default:"
                            + " ${DEFAULT-VALUE}",
            defaultValue = "2",
            converter = ToleranceOption.LevelsReader.class)
    private double levels;

    @Option(
            names = "--error",
            paramLabel = "E",
            description =
                    "the share of the pixels that may be off by more, 0 to 1; default:"
                            + " ${DEFAULT-VALUE}",
            defaultValue = "0",
            converter = ToleranceOption.ShareReader.class)
    private double share;

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
            description = "as of ./lab render; default: the scene's",
            converter = CameraOption.class)
    private SphericalView camera;

    @Option(names = "--json", description = "prints one JSON object")
    private boolean json;

    @Option(
            names = "--prove",
            description = "draws all combinations and names the cheapest within the tolerance")
    private boolean prove;

    @Option(
            names = "--costs",
            paramLabel = "FILE",
            description =
                    "measures what work costs on this machine, some minutes, plans by that and writes"
                            + " it to FILE")
    private Path measured;

    @Option(names = "--out", paramLabel = "FILE.png", description = "writes the least picture")
    private Path out;

    public PlanCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        RenderRequest request = request();
        Tolerance tolerance = ToleranceOption.of(pixels, levels, share);
        requirePng();
        if (measured != null) WholeFile.requireWritable(measured);
        RenderMemory.require(request, 6);
        var planner = new Planner(Runtime.getRuntime().availableProcessors(), costs());
        var progress = new RenderProgress(console);
        PlanTrial trial = PlanTrial.of(planner, request, tolerance, ROUNDS, progress);
        List<Combination> proof =
                prove
                        ? BruteForce.within(trial.plan(), trial.full(), tolerance, ROUNDS, progress)
                        : List.of();
        if (out != null) WholeFile.write(out, PngFile.bytes(trial.least().image()));
        var path = PlanPath.of(planner.fresh(), request, tolerance, PICTURES);
        var report = new PlanReport(trial, path, planner.costOrigin(), proof);
        if (!json) report.print(console.out(), console.language().inWindow());
        else
            try (JsonGenerator generator = PrettyJson.to(console.out())) {
                report.write(generator);
            }
        return ExitCode.DONE;
    }

    private void requirePng() {
        if (out == null) return;
        if (!out.toString().toLowerCase(Locale.ROOT).endsWith(".png"))
            throw Complaint.badInput(out + ": unknown extension; allowed is .png");
        WholeFile.requireWritable(out);
    }

    private RenderRequest request() {
        try {
            ShownScene opened = shown.open(console);
            double zoom = opened.settings().get(SceneSetting.ZOOM).orElse(1.0);
            Scene scene = opened.scene().zoomed(zoom);
            SphericalView eye = camera == null ? scene.defaultCamera() : camera;
            return new RenderRequest(
                    scene,
                    Renderer.PIPELINE,
                    "phong",
                    "perspective",
                    eye,
                    size.width(),
                    size.height());
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private Costs costs() {
        if (measured == null) return Costs.measured();
        List<String> lines =
                CostStudy.lines(
                        line -> {
                            if (!json) console.err().println(line);
                        });
        String text = String.join("\n", lines) + "\n";
        WholeFile.write(measured, text.getBytes(StandardCharsets.UTF_8));
        return Costs.measured().with(lines);
    }
}
