package rasterlab.app.tour;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.tour.LabPictures.TabLook;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.StudySettings;

/** Makes the tour: a folder with pictures and one page that shows them. */
public final class Tour {
    private final Path folder;
    private final Language language;
    private final PrintStream progress;

    /**
     * @param folder where the page and its pictures go; files of other names are left alone
     * @param language of the page
     * @param progress told about each step in one line
     */
    public Tour(Path folder, Language language, PrintStream progress) {
        this.folder = folder;
        this.language = language;
        this.progress = progress;
    }

    /**
     * Makes every part and the page, the labs in each language and theme.
     *
     * @param home the folder of the {@code ./lab} script, which starts the server; none if unknown
     * @return whether every part could be made
     * @throws Complaint if the folder cannot be written to
     */
    public boolean make(Optional<Path> home) throws InterruptedException {
        return make(parts(home, TabLook.all(), StudySettings.quick()));
    }

    /**
     * Makes the same in little time: the labs only in the page's language and light.
     *
     * @param timing how long each study takes its time
     */
    public boolean makeQuickly(Optional<Path> home, StudySettings timing)
            throws InterruptedException {
        return make(parts(home, List.of(new TabLook(LabTheme.LIGHT, language)), timing));
    }

    /** Makes those parts and the page; returns and throws the same. */
    boolean make(List<TourPart> parts) throws InterruptedException {
        WholeFile.requireFolder(folder.resolve(TourPage.PICTURES));
        WholeFile.requireWritable(index());
        var page = new TourPage(folder, language, progress);
        boolean whole = true;
        for (TourPart part : parts) whole &= made(part, page);
        byte[] html = page.html().getBytes(StandardCharsets.UTF_8);
        WholeFile.write(index(), html);
        return whole;
    }

    /** The page. */
    public Path index() {
        return folder.resolve("index.html");
    }

    private List<TourPart> parts(Optional<Path> home, List<TabLook> looks, StudySettings timing) {
        var studies = new TourStudies(timing, Texts.of("tour", language), progress::println);
        return List.of(
                new LabPictures(name -> true, () -> studies.of(new LineTopic()), looks),
                new ScenePictures(),
                new StudySection(studies),
                new HazardSection(),
                new GradingSection(home));
    }

    private boolean made(TourPart part, TourPage page) throws InterruptedException {
        page.begin(part.key());
        try {
            part.make(page);
            return true;
        } catch (InterruptedException e) {
            throw e;
        } catch (Exception | LinkageError e) {
            page.fail(e);
            return false;
        }
    }
}
