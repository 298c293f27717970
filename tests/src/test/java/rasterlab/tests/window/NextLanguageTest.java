package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JComboBox;
import org.assertj.swing.core.BasicComponentFinder;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.tests.display.OwnDisplay;

/** A window that was asked to speak Russian this once, and is English otherwise. */
@Tag("slow")
@Timeout(300)
@ExtendWith(OwnDisplay.class)
class NextLanguageTest {
    @TempDir Path folder;
    private final List<Object> wrong = new CopyOnWriteArrayList<>();
    private LabFrame frame;

    @BeforeEach
    void open() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        frame =
                GuiActionRunner.execute(
                        () -> {
                            LabTheme.LIGHT.install();
                            var made =
                                    new LabFrame(
                                            LabModels.first(wrong::add),
                                            LabSettings.first(Language.RUSSIAN),
                                            Language.ENGLISH,
                                            file(),
                                            LabsFile.nextTo(settings(), wrong::add),
                                            wrong::add);
                            made.addNotify();
                            return made;
                        });
    }

    private Path settings() {
        return folder.resolve("window.properties");
    }

    private SettingsFile file() {
        return new SettingsFile(settings(), wrong::add);
    }

    private void close() {
        GuiActionRunner.execute(frame::dispose);
        GuiActionRunner.execute(() -> {}); // The closed window's own event has run to its end.
        assertEquals(List.of(), wrong);
    }

    @Test
    @DisplayName("a window in which nothing was changed writes over what another one keeps")
    void nothingIsWrittenWhereNothingWasChanged() {
        close();
        assertFalse(Files.exists(settings()));
    }

    @Test
    @DisplayName("the language that is spoken this once cannot be chosen to stay")
    void languageThatIsSpokenCanBeKept() {
        GuiActionRunner.execute(
                () -> {
                    JComboBox<?> list =
                            BasicComponentFinder.finderWithCurrentAwtHierarchy()
                                    .findByName(frame, "language", JComboBox.class);
                    list.setSelectedIndex(Language.RUSSIAN.ordinal());
                });
        close();
        assertEquals(
                Language.RUSSIAN,
                file().load(LabSettings.first(Language.ENGLISH)).look().language());
    }
}
