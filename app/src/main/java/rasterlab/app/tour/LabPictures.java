package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.app.card.LabRoom;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.LabSnapshot;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.TabRooms;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.study.Study;

/** Every tab of the window in each look, painted without a display. */
final class LabPictures implements TourPart {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;

    private static final String CHECKED = "line-bresenham";

    /**
     * A tab.
     *
     * @param caption what it is, in a language
     * @param preparation gives once what prepares the tab in each look
     */
    private record Shot(
            String name,
            String tab,
            Function<Language, String> caption,
            Supplier<Consumer<LabModels>> preparation) {
        /** A shot of what the tour itself made before. */
        static Shot ofTour(String name, String tab, Supplier<Consumer<LabModels>> preparation) {
            return new Shot(
                    name,
                    tab,
                    language -> Texts.of("tour", language).text("labs." + name),
                    preparation);
        }
    }

    /** How a tab looks. */
    record TabLook(LabTheme theme, Language language) {
        private static final List<LabTheme> THEMES = List.of(LabTheme.LIGHT, LabTheme.DARK);

        /** Each theme in each language. */
        static List<TabLook> all() {
            return THEMES.stream()
                    .flatMap(
                            theme ->
                                    Stream.of(Language.values())
                                            .map(language -> new TabLook(theme, language)))
                    .toList();
        }

        private String themeName() {
            return theme.name().toLowerCase(Locale.ROOT);
        }
    }

    private final Predicate<String> wanted;
    private final Supplier<Study> charted;
    private final List<TabLook> looks;
    private final List<Shot> shots = new ArrayList<>();

    /**
     * @param wanted tells by their names which pictures are made
     * @param charted the study whose chart is shown; asked only where that picture is made
     * @param looks of each picture
     */
    LabPictures(Predicate<String> wanted, Supplier<Study> charted, List<TabLook> looks) {
        this.wanted = wanted;
        this.charted = charted;
        this.looks = looks;
        Map<String, Shot> further =
                Map.of(
                        "study",
                        Shot.ofTour("chart", "study", this::measured),
                        "exercises",
                        Shot.ofTour("checked", "exercises", LabPictures::wrongSolution));
        for (LabRoom<?> room : TabRooms.all()) {
            of(room).forEach(shots::add);
            Optional.ofNullable(further.get(room.name())).ifPresent(shots::add);
        }
    }

    private static <M> Stream<Shot> of(LabRoom<M> room) {
        return room.shots().stream()
                .map(
                        shot ->
                                new Shot(
                                        shot.name(),
                                        room.name(),
                                        language ->
                                                Texts.of(room.texts(), language)
                                                        .text("tour." + shot.name()),
                                        () -> models -> shot.prepare().accept(models.of(room))));
    }

    @Override
    public String key() {
        return "labs";
    }

    @Override
    public void make(TourPage page) throws InterruptedException {
        for (Shot shot : shots) {
            if (!wanted.test(shot.name())) continue;
            page.heading(shot.caption().apply(page.texts().language()));
            Consumer<LabModels> prepare = shot.preparation().get();
            List<TourPage.CaptionedPicture> figures = new ArrayList<>();
            for (TabLook look : looks) figures.add(figure(page, shot, prepare, look));
            page.gallery(figures);
        }
    }

    private static TourPage.CaptionedPicture figure(
            TourPage page, Shot shot, Consumer<LabModels> prepare, TabLook look)
            throws InterruptedException {
        Language language = look.language();
        String caption = language.ownName() + ", " + page.texts().text("theme." + look.themeName());
        page.say(shot.caption().apply(page.texts().language()) + ": " + caption);
        String name =
                String.join(
                        "-", "lab", shot.name(), language.locale().getLanguage(), look.themeName());
        return page.picture(
                name,
                LabSnapshot.of(shot.tab(), look.theme(), language, prepare, WIDTH, HEIGHT),
                caption);
    }

    private Consumer<LabModels> measured() {
        Study study = charted.get();
        return models -> models.study().show(study);
    }

    /** A wrong solution that was checked, so that what is expected is seen beside what is drawn. */
    private static Consumer<LabModels> wrongSolution() {
        String source = GradingSection.source("wrong");
        return models -> {
            models.exercises().choose(CHECKED);
            models.exercises().type(source);
            models.exercises().check();
        };
    }
}
