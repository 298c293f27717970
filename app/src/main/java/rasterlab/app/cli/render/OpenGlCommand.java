package rasterlab.app.cli.render;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.SoftwareHalf;
import rasterlab.app.opengl.software.Deviations;
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
            "Each --set is one of the tab's settings, listed below with their options; the others are as"
                    + " the tab opens."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the picture was written",
            "2:a setting or the image is wrong, or the file cannot be written"
        })
public final class OpenGlCommand implements Callable<Integer> {
    private static final String EXAMPLE =
            "./lab opengl --set scene=globe --set texture-2d=on --out globe.png";

    private final Console console;

    @Option(
            names = "--set",
            paramLabel = "SETTING=OPTION",
            description = "may be given once for each setting, such as shade-model=GL_FLAT")
    private List<String> settings = List.of();

    @Option(
            names = "--image",
            paramLabel = "FILE",
            description =
                    "PNG, JPEG, GIF or BMP as the texture: image=file, and texture-2d=on, are then"
                            + " taken where --set does not say them")
    private Path image;

    @Option(
            names = "--turn",
            paramLabel = "DEGREES",
            description =
                    "turn of the scene about its vertical axis, 0 to below 360; default: the tab's")
    private Double turn;

    @Option(
            names = "--tilt",
            paramLabel = "DEGREES",
            description = "tilt towards the eye, -90 to 90; default: the tab's")
    private Double tilt;

    @Option(
            names = "--distance",
            paramLabel = "D",
            description =
                    "distance of the eye, "
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

    /** The command with the settings and their options in its help. */
    public static CommandLine commandLine(Console console) {
        var line = new CommandLine(new OpenGlCommand(console));
        UsageMessageSpec usage = line.getCommandSpec().usageMessage();
        Texts texts = console.language().texts();
        List<String> below = new ArrayList<>(List.of("", texts.text("settings")));
        below.addAll(OpenGlSettings.lines());
        below.addAll(List.of("", texts.text("example") + ": " + EXAMPLE));
        usage.footer(below.toArray(String[]::new));
        return line;
    }

    @Override
    public Integer call() {
        if (!out.toString().toLowerCase(Locale.ROOT).endsWith(".png"))
            throw Complaint.badInput(out + ": unknown extension; allowed is .png");
        WholeFile.requireWritable(out);
        GlChoice choice = choice();
        WholeFile.write(
                out, PngFile.bytes(SoftwareHalf.of(choice, size.width(), size.height()).image()));
        tellDeviations(choice);
        console.tell("wrote", out.toString());
        return ExitCode.DONE;
    }

    private GlChoice choice() {
        GlChoice first = GlChoice.first();
        try {
            Map<Setting, String> options = new EnumMap<>(first.options());
            options.putAll(given());
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

    /** The settings that the options give, each once. */
    private Map<Setting, String> given() {
        Map<Setting, String> given = new EnumMap<>(Setting.class);
        for (String each : settings) set(each, given);
        if (image == null) return given;
        if (!given.containsKey(Setting.IMAGE)) given.putIfAbsent(Setting.TEXTURE_2D, "on");
        String shown = given.computeIfAbsent(Setting.IMAGE, setting -> "file");
        if (!shown.equals("file"))
            throw new IllegalArgumentException(
                    "--image is the texture of image=file, but --set image=%s asks for another"
                            .formatted(shown));
        return given;
    }

    private static void set(String text, Map<Setting, String> given) {
        int equals = text.indexOf('=');
        if (equals < 0)
            throw new IllegalArgumentException(
                    "--set needs SETTING=OPTION such as shade-model=GL_FLAT, got '" + text + "'");
        List<Setting> all = Arrays.asList(Setting.values());
        Setting setting = Named.find("setting", text.substring(0, equals), all, Setting::code);
        String before = given.put(setting, text.substring(equals + 1));
        if (before != null)
            throw new IllegalArgumentException(
                    "--set gives %s twice, '%s' and '%s'"
                            .formatted(setting.code(), before, given.get(setting)));
    }

    /** Tells what of the state the picture does not have, as the tab does beside its pictures. */
    private void tellDeviations(GlChoice choice) {
        Texts texts = Texts.of("opengl", console.language().inWindow());
        for (Deviations each : Deviations.of(choice))
            console.tell("note", texts.text("why." + each.code()));
    }
}
