package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import rasterlab.app.opengl.SoftwareHalf;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlChoice.ImageTexture;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.naming.Named;

/** Draws what the software pipeline makes of a state of OpenGL. */
@Command(
        name = "opengl",
        mixinStandardHelpOptions = true,
        description = {
            "Draws, without OpenGL, the picture that the tab OpenGL shows beside OpenGL's own.",
            "Each --set is one of the tab's settings; the others are as the tab opens."
        },
        footer = {
            "",
            "Example: ./lab opengl --set scene=globe --set texture-2d=on --out globe.png"
        })
final class OpenGlCommand implements Callable<Integer> {
    private final Console console;

    @Option(
            names = "--set",
            paramLabel = "SETTING=OPTION",
            description = "may be given for each setting, such as shade-model=GL_FLAT")
    private List<String> settings = List.of();

    @Option(names = "--image", paramLabel = "FILE", description = "the texture of image=file")
    private Path image;

    @Option(
            names = "--turn",
            paramLabel = "DEGREES",
            description =
                    "of the scene about its vertical axis, 0 to below 360; default: the tab's")
    private Double turn;

    @Option(
            names = "--tilt",
            paramLabel = "DEGREES",
            description = "towards the eye, -90 to 90; default: the tab's")
    private Double tilt;

    @Option(
            names = "--distance",
            paramLabel = "D",
            description =
                    "of the eye, "
                            + GlChoice.NEAREST
                            + " to "
                            + GlChoice.FARTHEST
                            + "; default:"
                            + " the tab's")
    private Double distance;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "in pixels, 1x1 to 8192x8192; default: ${DEFAULT-VALUE}",
            defaultValue = "800x600",
            converter = PictureSize.Reader.class)
    private PictureSize size;

    @Option(names = "--out", paramLabel = "FILE.png", required = true, description = "the picture")
    private Path out;

    OpenGlCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        if (!out.toString().toLowerCase(Locale.ROOT).endsWith(".png"))
            throw Complaint.badInput(out + ": unknown extension; allowed is .png");
        WholeFile.requireWritable(out);
        GlChoice choice = choice();
        WholeFile.write(
                out, PngFile.bytes(SoftwareHalf.of(choice, size.width(), size.height()).image()));
        console.err().println("wrote " + out);
        return ExitCode.DONE;
    }

    private GlChoice choice() {
        GlChoice first = GlChoice.first();
        try {
            Map<Setting, String> options = new EnumMap<>(first.options());
            for (String given : settings) set(given, options);
            Optional<ImageTexture> file = Optional.ofNullable(image).map(SoftwareHalf::image);
            return new GlChoice(
                    options,
                    turn == null ? first.turn() : turn,
                    tilt == null ? first.tilt() : tilt,
                    distance == null ? first.distance() : distance,
                    file);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private static void set(String given, Map<Setting, String> options) {
        int equals = given.indexOf('=');
        if (equals < 0)
            throw new IllegalArgumentException(
                    "--set needs SETTING=OPTION such as shade-model=GL_FLAT, got '" + given + "'");
        List<Setting> all = Arrays.asList(Setting.values());
        Setting setting = Named.find("setting", given.substring(0, equals), all, Setting::code);
        options.put(setting, given.substring(equals + 1));
    }
}
