package rasterlab.app.opengl;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.opengl.software.SoftwarePainter;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlChoice.ImageTexture;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.LabImages;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.texture.Texture;

/** The picture of the software pipeline beside OpenGL's, without the window. */
public final class SoftwareHalf {
    private static final String OUT = "opengl-software.png";

    private SoftwareHalf() {}

    /**
     * @param width in pixels, from 1
     * @param height in pixels, from 1
     */
    public static Raster of(GlChoice choice, int width, int height) {
        try (var painter = new SoftwarePainter()) {
            var frame = new GlFrame(choice, width, height, new LabImages().of(choice));
            return painter.draw(frame, () -> false);
        }
    }

    /**
     * The image of a file as a texture.
     *
     * @throws Complaint naming the file and what is wrong with it
     */
    public static ImageTexture image(Path file) {
        return ImageLoading.image(file, Texture.LARGEST);
    }

    /** The shell command that draws it, in whatever folder it is run. */
    static String command(GlChoice choice, int width, int height) {
        GlChoice first = GlChoice.first();
        List<String> words = new ArrayList<>(List.of("./lab opengl"));
        for (Setting each : Setting.values())
            if (!choice.is(each, first.get(each)))
                words.add("--set " + each.code() + "=" + choice.get(each));
        if (choice.is(Setting.IMAGE, "file"))
            words.add("--image " + ShellPath.quoted(choice.file().orElseThrow().file()));
        words.add("--turn " + choice.turn());
        words.add("--tilt " + choice.tilt());
        words.add("--distance " + choice.distance());
        words.add(String.format(Locale.ROOT, "--size %dx%d", width, height));
        words.add("--out " + OUT);
        return String.join(" ", words);
    }
}
