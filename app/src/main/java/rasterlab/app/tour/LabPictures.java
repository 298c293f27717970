package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabModels;
import rasterlab.app.shell.LabSnapshot;
import rasterlab.app.shell.LabTheme;
import rasterlab.engine.line.Segment;

/** Every tab of the window in each language and theme, painted without a display. */
final class LabPictures implements TourPart {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    private static final List<String> TABS = List.of("line", "clip", "visibility");

    @Override
    public String key() {
        return "labs";
    }

    @Override
    public void make(TourPage page) throws InterruptedException {
        for (String tab : TABS) {
            page.heading(page.texts().text("labs." + tab));
            List<TourPage.Figure> figures = new ArrayList<>();
            for (LabTheme theme : LabTheme.values())
                for (Language language : Language.values())
                    figures.add(figure(page, tab, theme, language));
            page.gallery(figures);
        }
    }

    private static TourPage.Figure figure(
            TourPage page, String tab, LabTheme theme, Language language)
            throws InterruptedException {
        String look = theme.name().toLowerCase(Locale.ROOT);
        String caption = language.ownName() + ", " + page.texts().text("theme." + look);
        page.say(page.texts().text("labs." + tab) + ": " + caption);
        String name = "lab-" + tab + "-" + language.locale().getLanguage() + "-" + look;
        return page.picture(
                name,
                LabSnapshot.of(tab, theme, language, LabPictures::showWhatFails, WIDTH, HEIGHT),
                caption);
    }

    /** Faulty methods where they fail, so that wrong pixels and parts are seen. */
    private static void showWhatFails(LabModels models) {
        models.line().show(new Segment(17, 9, 2, 3));
        models.line().chooseMethod("bresenham-textbook");
        models.clip().chooseMethod("cohen-sutherland-textbook");
        models.clip().compareWith("cohen-sutherland");
    }
}
