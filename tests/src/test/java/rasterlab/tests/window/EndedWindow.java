package rasterlab.tests.window;

import java.awt.EventQueue;
import java.nio.file.Path;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.tests.bench.window.WindowContent;

/** A window of its own process that changes something, says so and is never closed. */
final class EndedWindow {
    static final String CHANGED = "changed";

    private EndedWindow() {}

    /**
     * @param arguments the settings' file
     */
    public static void main(String[] arguments) {
        Path settings = Path.of(arguments[0]);
        EventQueue.invokeLater(() -> open(settings));
    }

    private static void open(Path settings) {
        LabTheme.LIGHT.install();
        LabModels models = LabModels.first(Throwable::printStackTrace);
        var frame =
                new LabFrame(
                        models,
                        LabSettings.first(Language.ENGLISH),
                        Language.ENGLISH,
                        new SettingsFile(settings, System.err::println),
                        LabsFile.nextTo(settings, System.err::println),
                        Throwable::printStackTrace);
        frame.setVisible(true);
        frame.wear(LabLook.first(Language.RUSSIAN).with(LabTheme.DARK));
        WindowContent.of(frame).show("spline");
        models.of(new LineRoom()).chooseMethod("dda");
        System.out.println(CHANGED);
    }
}
