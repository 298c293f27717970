package rasterlab.app.tour;

import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabModels;
import rasterlab.app.shell.LabTab;
import rasterlab.app.shell.LabTabs;
import rasterlab.app.shell.LabTheme;
import rasterlab.app.shell.OffscreenPainter;

/** Every tab of the window in each language and theme, painted without a display. */
final class LabPictures implements TourPart {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;

    @Override
    public String key() {
        return "labs";
    }

    @Override
    public void make(TourPage page) throws InterruptedException {
        List<TourPage.Figure> figures = new ArrayList<>();
        for (LabTheme theme : LabTheme.values())
            for (Language language : Language.values()) figures.addAll(made(page, theme, language));
        page.gallery(figures);
    }

    private List<TourPage.Figure> made(TourPage page, LabTheme theme, Language language)
            throws InterruptedException {
        var failure = new AtomicReference<Throwable>();
        LabTabs tabs = created(theme, language, failure);
        List<TourPage.Figure> figures = new ArrayList<>();
        try {
            for (LabTab tab : tabs.all()) {
                BufferedImage image = OffscreenPainter.paint(tab.panel(), WIDTH, HEIGHT);
                if (failure.get() != null)
                    throw new IllegalStateException(tab.name() + ": " + failure.get());
                figures.add(figure(page, tab, theme, language, image));
            }
        } finally {
            onEventThread(tabs::close);
        }
        return figures;
    }

    private static LabTabs created(
            LabTheme theme, Language language, AtomicReference<Throwable> failure)
            throws InterruptedException {
        var tabs = new AtomicReference<LabTabs>();
        onEventThread(
                () -> {
                    theme.install();
                    tabs.set(LabTabs.create(LabModels.first(), language, failure::set));
                });
        return tabs.get();
    }

    private static TourPage.Figure figure(
            TourPage page, LabTab tab, LabTheme theme, Language language, BufferedImage image) {
        String look = theme.name().toLowerCase(Locale.ROOT);
        String caption =
                tab.title() + ", " + language.ownName() + ", " + page.texts().text("theme." + look);
        String name = "lab-" + tab.name() + "-" + language.locale().getLanguage() + "-" + look;
        return page.picture(name, image, caption);
    }

    private static void onEventThread(Runnable work) throws InterruptedException {
        try {
            EventQueue.invokeAndWait(work);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause().toString(), e.getCause());
        }
    }
}
