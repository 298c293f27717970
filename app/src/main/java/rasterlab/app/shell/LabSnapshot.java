package rasterlab.app.shell;

import java.awt.image.BufferedImage;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;

/** Pictures of the window's content made without a window, with or without a display. */
public final class LabSnapshot {
    private LabSnapshot() {}

    /**
     * One tab with the strip of tabs above it. Not on the event thread.
     *
     * @param tab name of the tab
     * @param prepare brings the labs where they should be, such as {@code models ->
     *     models.study().choose("line")}; called on the event thread
     * @param width view units, at least 1
     * @param height view units, at least 1
     * @throws IllegalStateException when the lab reported a failure
     */
    public static BufferedImage of(
            String tab,
            LabTheme theme,
            Language language,
            Consumer<LabModels> prepare,
            int width,
            int height)
            throws InterruptedException {
        var failure = new AtomicReference<Throwable>();
        var made = new AtomicReference<Made>();
        OffscreenPainter.onEventThread(
                () -> made.set(made(tab, theme, language, prepare, failure)));
        try {
            BufferedImage image = OffscreenPainter.paint(made.get().content(), width, height);
            if (failure.get() != null) throw new IllegalStateException(tab, failure.get());
            return image;
        } finally {
            OffscreenPainter.onEventThread(made.get()::close);
        }
    }

    private static Made made(
            String tab,
            LabTheme theme,
            Language language,
            Consumer<LabModels> prepare,
            AtomicReference<Throwable> failure) {
        theme.install();
        LabModels models = LabModels.first(failure::set);
        prepare.accept(models);
        LabTabs tabs = LabTabs.create(models, language, failure::set);
        tabs.named(tab);
        LabLook look = LabLook.first(language).with(theme);
        var content = new LabContent(tabs, tab, look, chosen -> {}, chosen -> {});
        return new Made(models, tabs, content);
    }

    private record Made(LabModels models, LabTabs tabs, LabContent content) {
        void close() {
            tabs.close();
            models.close();
        }
    }
}
