package rasterlab.app.shell;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import rasterlab.app.clip.ClipPanel;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.LinePanel;
import rasterlab.app.spline.SplinePanel;
import rasterlab.app.visibility.VisibilityPanel;
import rasterlab.engine.naming.Named;

/** The labs' panels in one language; made again for another, while the models live on. */
public final class LabTabs implements AutoCloseable {
    private final Language language;
    private final List<LabTab> tabs;
    private final Runnable close;

    private LabTabs(Language language, List<LabTab> tabs, Runnable close) {
        this.language = language;
        this.tabs = List.copyOf(tabs);
        this.close = close;
    }

    /**
     * The tabs in the look that is installed ({@link LabTheme#install}). On the event thread.
     *
     * @param onFailure told what a lab could not do, on any thread
     */
    public static LabTabs create(
            LabModels models, Language language, Consumer<Throwable> onFailure) {
        Texts texts = Texts.of("shell", language);
        var line = new LinePanel(models.line(), language, onFailure);
        var clip = new ClipPanel(models.clip(), language, onFailure);
        var visibility = new VisibilityPanel(models.visibility(), language, onFailure);
        var spline = new SplinePanel(models.spline(), language, onFailure);
        return new LabTabs(
                language,
                List.of(
                        tab("line", texts, line, line::focusPicture),
                        tab("clip", texts, clip, clip::focusPicture),
                        tab("visibility", texts, visibility, visibility::focusPicture),
                        tab("spline", texts, spline, spline::focusPicture)),
                () -> {
                    line.close();
                    clip.close();
                    visibility.close();
                    spline.close();
                });
    }

    private static LabTab tab(String name, Texts texts, JComponent panel, Runnable focusPicture) {
        String key = "tab." + name;
        return new LabTab(
                name,
                texts.label(key),
                texts.mnemonic(key),
                texts.mnemonicIndex(key),
                panel,
                focusPicture);
    }

    public Language language() {
        return language;
    }

    public List<LabTab> all() {
        return tabs;
    }

    /**
     * @throws IllegalArgumentException if there is no tab of that name
     */
    public LabTab named(String name) {
        return Named.find("tab", name, tabs, LabTab::name);
    }

    /** Stops what the panels play and listen to. On the event thread. */
    @Override
    public void close() {
        close.run();
    }
}
