package rasterlab.app.shell;

import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.OwnChips;
import rasterlab.app.canvas.lab.ShownHazard;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.card.LabRoom;
import rasterlab.app.found.FoundCases;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.PracticeCards;
import rasterlab.app.shell.labs.HandInOffers;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.shell.labs.TabRooms;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;
import rasterlab.engine.naming.Named;

/** The labs' panels in one language; made again for another, while the models live on. */
public final class LabTabs implements AutoCloseable {
    /** The names of the tabs, in the order of the window. */
    public static final List<String> NAMES =
            TabRooms.all().stream().<String>map(LabRoom::name).toList();

    private final LabModels models;
    private final Language language;
    private final List<LabTab> tabs;
    private final LabOpening opening;
    private final Consumer<Throwable> onFailure;

    private LabTabs(
            LabModels models,
            Language language,
            List<LabTab> tabs,
            LabOpening opening,
            Consumer<Throwable> onFailure) {
        this.models = models;
        this.language = language;
        this.tabs = List.copyOf(tabs);
        this.opening = opening;
        this.onFailure = onFailure;
    }

    /**
     * The tabs in the look that is installed ({@link LabTheme#install}). On the event thread.
     *
     * @param onFailure told what a lab could not do, on any thread
     */
    public static LabTabs create(
            LabModels models, Language language, Consumer<Throwable> onFailure) {
        var opening =
                new LabOpening(models, LabTabs::tryHazard, EventQueue::invokeLater, onFailure);
        Texts texts = Texts.of("shell", language);
        var around = new LabRoom.Surroundings(language, opening, onFailure);
        List<LabTab> tabs =
                TabRooms.all().stream().map(room -> tab(room, texts, models, around)).toList();
        return new LabTabs(models, language, tabs, opening, onFailure);
    }

    private static <M> LabTab tab(
            LabRoom<M> room, Texts texts, LabModels models, LabRoom.Surroundings around) {
        return new LabTab(
                room.name(),
                texts.text("tab." + room.name()),
                () -> {
                    models.make(room.name());
                    room.prepare(models.of(room));
                },
                () -> panel(room, models, around));
    }

    /** A lab that shows topics can ask for their steps too. */
    private static <M> LabPanel panel(
            LabRoom<M> room, LabModels models, LabRoom.Surroundings around) {
        LabPanel lab = room.panel(models.of(room), around);
        models.found()
                .ifPresent(
                        kept ->
                                OwnChips.offer(
                                        lab,
                                        new FoundCases(kept, around.opening(), around.language())));
        return room.cards().isEmpty()
                ? lab
                : new PracticeCards(lab, models.practice(room), around.language());
    }

    /** These tabs once more, in another language or theme. */
    LabTabs again(Language language) {
        return create(models, language, onFailure);
    }

    private static void tryHazard(Runnable work) {
        var thread = new Thread(work, "hazard");
        thread.setDaemon(true);
        thread.start();
    }

    public Language language() {
        return language;
    }

    /** The opening that shows inputs in their tabs. */
    LabOpening opening() {
        return opening;
    }

    /** Remembers what is said over the labs of handing their input in. */
    HandInOffers handIn() {
        return models.handIn();
    }

    /** Receives what a lab could not do, on any thread. */
    Consumer<Throwable> onFailure() {
        return onFailure;
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

    /** Lets each tab, once it is made, play and tell what the one of its name did. */
    void goOnAs(List<Doing> before) {
        for (Doing was : before) {
            was.playing().ifPresent(named(was.tab())::goOn);
            was.hazard().ifPresent(named(was.tab())::tellAgain);
        }
    }

    /** Tells the work of each tab, seen or not. */
    List<Doing> doing() {
        return tabs.stream()
                .map(tab -> new Doing(tab.name(), tab.playing(), tab.shownHazard()))
                .toList();
    }

    /**
     * Tells the work of a tab's lab that its model does not know.
     *
     * @param playing how it plays
     * @param hazard the hazard that is told over its stage
     */
    record Doing(String tab, Optional<StepPlayer.Playing> playing, Optional<ShownHazard> hazard) {}

    /** The tab of that name, or the first. */
    LabTab namedOrFirst(String name) {
        return tabs.stream().filter(tab -> tab.name().equals(name)).findFirst().orElse(tabs.get(0));
    }

    /** Stops what the panels play and listen to. On the event thread. */
    @Override
    public void close() {
        tabs.forEach(LabTab::close);
    }
}
