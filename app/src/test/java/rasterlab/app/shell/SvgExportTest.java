package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JButton;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;

class SvgExportTest {
    @Test
    @DisplayName("a lab copies its stage as a picture only, or saves it nowhere")
    void whatIsCopiedAsAPictureIsCopiedAsADrawingAndSavedToo() throws InterruptedException {
        var failure = new AtomicReference<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    try (LabModels models = LabModels.first(failure::set);
                            LabTabs tabs = LabTabs.create(models, Language.ENGLISH, failure::set)) {
                        for (LabTab tab : tabs.all()) {
                            List<String> buttons = buttons(tab.panel());
                            long copied = buttons.stream().filter("copyPicture"::equals).count();
                            for (String way : List.of("copySvg", "savePicture"))
                                assertEquals(
                                        copied,
                                        buttons.stream().filter(way::equals).count(),
                                        tab.name() + ": " + buttons);
                        }
                    }
                });
        assertEquals(null, failure.get());
    }

    private static List<String> buttons(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (child instanceof JButton button && button.getName() != null)
                found.add(button.getName());
            if (child instanceof Container inner) found.addAll(buttons(inner));
        }
        return found;
    }
}
