package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineMode;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.polygon.PolygonMode;
import rasterlab.app.shell.LabModels;
import rasterlab.app.shell.LabSnapshot;
import rasterlab.app.shell.LabTheme;
import rasterlab.app.spline.SplineMode;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Study;

/** Every tab of the window in each look, painted without a display. */
final class LabPictures implements TourPart {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;

    private static final String CHECKED = "line-bresenham";

    /**
     * A tab.
     *
     * @param preparation gives once what prepares the tab in each look
     */
    private record Shot(String name, String tab, Supplier<Consumer<LabModels>> preparation) {
        Shot(String name, String tab, Consumer<LabModels> prepare) {
            this(name, tab, () -> prepare);
        }
    }

    /** How a tab looks. */
    record Look(LabTheme theme, Language language) {
        private static final List<LabTheme> THEMES = List.of(LabTheme.LIGHT, LabTheme.DARK);

        /** Each theme in each language. */
        static List<Look> all() {
            return THEMES.stream()
                    .flatMap(
                            theme ->
                                    Stream.of(Language.values())
                                            .map(language -> new Look(theme, language)))
                    .toList();
        }

        private String themeName() {
            return theme.name().toLowerCase(Locale.ROOT);
        }
    }

    private final Predicate<String> wanted;
    private final Supplier<Study> charted;
    private final List<Look> looks;
    private final List<Shot> shots =
            List.of(
                    new Shot("coordinates", "coordinates", models -> {}),
                    coordinates("transformations", CoordinatesMode.TRANSFORMATIONS),
                    coordinates("stack", CoordinatesMode.STACK),
                    coordinates("rotation", CoordinatesMode.ROTATION),
                    coordinates("meeting", CoordinatesMode.MEETING),
                    new Shot("line", "line", LabPictures::showWhatFails),
                    new Shot("circle", "line", LabPictures::showParametricEllipse),
                    new Shot(
                            "brightness",
                            "line",
                            models -> models.line().chooseMode(LineMode.BRIGHTNESS)),
                    new Shot("polygon", "polygon", LabPictures::showOverflow),
                    new Shot(
                            "seed",
                            "polygon",
                            models -> models.polygon().chooseMode(PolygonMode.SEED)),
                    new Shot("clip", "clip", models -> {}),
                    new Shot("visibility", "visibility", models -> {}),
                    new Shot("order", "visibility", LabPictures::showOrder),
                    new Shot(
                            "depth-rows",
                            "visibility",
                            models ->
                                    models.visibility()
                                            .rows()
                                            .show("depth-buffer", "crossing", "z16")),
                    new Shot("light", "light", models -> models.light().drawNormals(true)),
                    new Shot("colours", "light", models -> models.light().showColours(true)),
                    textureRows("texture-rows", "texture-mapping", "floor", "affine"),
                    textureRows("filter-rows", "texture-filter", "aliasing", "nearest"),
                    new Shot("spline", "spline", models -> {}),
                    new Shot(
                            "function",
                            "spline",
                            models -> models.spline().show(SplineMode.FUNCTION)),
                    new Shot("opengl", "opengl", models -> {}),
                    new Shot("globe", "opengl", LabPictures::showGlobe),
                    new Shot("study", "study", models -> {}),
                    new Shot("chart", "study", this::measured),
                    new Shot("exercises", "exercises", models -> {}),
                    new Shot("checked", "exercises", LabPictures::wrongSolution));

    /**
     * @param wanted tells by their names which pictures are made
     * @param charted the study whose chart is shown; asked only where that picture is made
     * @param looks of each picture
     */
    LabPictures(Predicate<String> wanted, Supplier<Study> charted, List<Look> looks) {
        this.wanted = wanted;
        this.charted = charted;
        this.looks = looks;
    }

    private static Shot coordinates(String name, CoordinatesMode mode) {
        return new Shot(name, "coordinates", models -> models.coordinates().show(mode));
    }

    private static Shot textureRows(String name, String topic, String hazard, String method) {
        return new Shot(name, "light", models -> models.light().rows().show(topic, hazard, method));
    }

    @Override
    public String key() {
        return "labs";
    }

    @Override
    public void make(TourPage page) throws InterruptedException {
        for (Shot shot : shots) {
            if (!wanted.test(shot.name())) continue;
            page.heading(page.texts().text("labs." + shot.name()));
            Consumer<LabModels> prepare = shot.preparation().get();
            List<TourPage.Figure> figures = new ArrayList<>();
            for (Look look : looks) figures.add(figure(page, shot, prepare, look));
            page.gallery(figures);
        }
    }

    private static TourPage.Figure figure(
            TourPage page, Shot shot, Consumer<LabModels> prepare, Look look)
            throws InterruptedException {
        Language language = look.language();
        String caption = language.ownName() + ", " + page.texts().text("theme." + look.themeName());
        page.say(page.texts().text("labs." + shot.name()) + ": " + caption);
        String name =
                String.join(
                        "-", "lab", shot.name(), language.locale().getLanguage(), look.themeName());
        return page.picture(
                name,
                LabSnapshot.of(shot.tab(), look.theme(), language, prepare, WIDTH, HEIGHT),
                caption);
    }

    /** Faulty methods where they fail, so that wrong pixels and parts are seen. */
    private static void showWhatFails(LabModels models) {
        models.line().show(new Segment(17, 9, 2, 3));
        models.line().chooseMethod("bresenham-textbook");
        models.clip().chooseMethod("cohen-sutherland-textbook");
        models.clip().compareWith("cohen-sutherland");
    }

    /** No order of whole boards is right; the list has the order in which they were drawn. */
    private static void showOrder(LabModels models) {
        models.visibility().compareColours("cyclic-overlap", "painter", "newell");
        models.visibility().watchSteps(true);
    }

    private static void showParametricEllipse(LabModels models) {
        models.line().chooseMode(LineMode.ELLIPSE);
        models.line().figures().chooseMethod("parametric");
        models.line().figures().compareWith("midpoint");
    }

    /** The plane as it looks to a method in 32 bits, far from the origin. */
    private static void showOverflow(LabModels models) {
        models.polygon().show(PolygonMode.TRIANGLE, "past-2-15");
        models.polygon().chooseMethod("sign-int");
    }

    private Consumer<LabModels> measured() {
        Study study = charted.get();
        return models -> models.study().show(study);
    }

    /** Checked, so that what is expected is seen beside what is drawn. */
    private static Consumer<LabModels> wrongSolution() {
        String source = GradingSection.source("wrong");
        return models -> {
            models.exercises().choose(CHECKED);
            models.exercises().type(source);
            models.exercises().check();
        };
    }

    private static void showGlobe(LabModels models) {
        models.opengl().set(Setting.SCENE, "globe");
        models.opengl().set(Setting.MIN_FILTER, "GL_LINEAR_MIPMAP_LINEAR");
    }
}
