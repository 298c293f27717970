package rasterlab.app.shell;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnProgram;
import rasterlab.app.shell.labs.HandInOffers;
import rasterlab.app.shell.labs.HandInOffers.Offer;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.tab.LabTab;
import rasterlab.app.shell.tab.OwnStrip;
import rasterlab.app.shell.tab.PlayerKeys;
import rasterlab.app.shell.tab.TabbedLabs;
import rasterlab.app.shell.tab.WindowKeys;
import rasterlab.exercises.Exercise;

/**
 * The content of the frame: the tabs, and the choice of language and theme at the end of their
 * strip.
 */
public final class LabContent extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Milliseconds after which it is looked again whether a program is waited for. */
    private static final int LOOK = 40;

    /** A shorter wait is not told: the picture would flicker. */
    private static final Duration LEAST = Duration.ofMillis(90);

    private final TabbedLabs pane;
    private final transient WindowKeys keys = new WindowKeys(this);
    private final transient PlayerKeys player = new PlayerKeys(() -> StepPlayer.seenIn(this));
    private final transient LabOpening opening;
    private final transient HandInOffers offers;
    private final transient Timer awaiting = new Timer(LOOK, e -> tellAwaited());

    /** The tab whose picture is marked as old. */
    private transient Optional<LabTab> awaited = Optional.empty();

    /** A hazard that a tab is about to show. */
    private transient Optional<String> opened = Optional.empty();

    /**
     * @param shown name of the tab to show; an unknown one is the first
     * @param onLook told how the user wants the window to look
     * @param onLanguage told the language that the user chose, which may be the present one
     */
    public LabContent(
            LabTabs labs,
            String shown,
            LabLook look,
            Consumer<LabLook> onLook,
            Consumer<Language> onLanguage) {
        super(new BorderLayout());
        Texts texts = Texts.of("shell", labs.language());
        opening = labs.opening();
        offers = labs.handIn();
        pane = new TabbedLabs(labs.all(), labs.onFailure(), texts);
        opening.showTabsBy(this::show);
        opening.tellHazardsTo(hazard -> opened = Optional.of(hazard));
        Map<String, Offer> before = offers.shown();
        opening.tellHandingInTo(
                (tab, exercise) -> tellHandingIn(tab, new Offer(exercise, false), texts));
        opening.tellOwnTo((tab, mine) -> tellOwn(tab, mine, texts), pane::tellNoOwn);
        before.forEach((tab, offer) -> tellHandingIn(tab, offer, texts));
        show(shown);
        pane.fill();
        pane.putClientProperty("JTabbedPane.leadingComponent", brand());
        pane.putClientProperty(
                "JTabbedPane.trailingComponent",
                new WindowLookControls(
                        texts, look, keys, onLook, onLanguage, () -> help(labs.language())));
        pane.bindSteps(keys);
        player.bind(keys);
        keys.bind(KeyStroke.getKeyStroke("F1"), () -> help(labs.language()));
        add(pane);
        setTransferHandler(StrayDrop.on(this, texts));
        DropForwarder.within(this);
        pane.addChangeListener(
                e -> {
                    pane.fill();
                    focusPicture();
                    tellHazard();
                });
        pane.addMouseListener(new ChoiceOfTheShownTab());
    }

    @Override
    public void addNotify() {
        super.addNotify();
        keys.listen();
        player.listen();
        awaiting.start();
    }

    @Override
    public void removeNotify() {
        awaiting.stop();
        keys.close();
        player.close();
        super.removeNotify();
    }

    /**
     * Gives the keyboard to the picture of the tab that is shown. Asked twice, since Swing moves
     * the focus out of what was hidden by itself, and sometimes later than it is first asked.
     */
    void focusPicture() {
        pane.focusPicture();
        EventQueue.invokeLater(pane::focusPicture);
    }

    /** Name of the tab that is shown, also while another is about to be. */
    String seen() {
        return pane.seen().name();
    }

    /** Name of the tab that is shown, or about to be. */
    public String shown() {
        return pane.chosen().name();
    }

    /** Shows the tab of that name; an unknown name leaves the one that is shown. */
    public void show(String tab) {
        pane.show(tab);
        tellHazard();
    }

    /**
     * Says over the stage what is special about a hazard that another tab brought, once it is seen.
     */
    private void tellHazard() {
        if (opened.isEmpty() || pane.seen() != pane.chosen()) return;
        Chips.tell(opened.get(), pane.seen().panel());
        opened = Optional.empty();
    }

    /** Says over a lab for which exercise its input can be handed in. */
    private void tellHandingIn(String tab, Offer offer, Texts texts) {
        Exercise exercise = offer.exercise();
        offers.show(tab, offer);
        var strip =
                new HandInStrip(
                        offer,
                        texts,
                        () -> handIn(tab, exercise),
                        () -> opening.showExercise(exercise),
                        () -> {
                            offers.hide(tab);
                            pane.tellNothing(tab);
                        });
        pane.tell(tab, strip);
    }

    private boolean handIn(String tab, Exercise exercise) {
        boolean handed = opening.handIn(exercise);
        offers.show(tab, new Offer(exercise, !handed));
        return handed;
    }

    /** Says over a lab from which exercise the program is that it shows. */
    private void tellOwn(String tab, OwnProgram mine, Texts texts) {
        offers.hide(tab);
        var strip =
                new OwnStrip(
                        mine.exercise(),
                        texts,
                        () -> opening.showExercise(mine.exercise()),
                        () -> {
                            opening.hideOwn(tab);
                            pane.tellNothing(tab);
                        });
        pane.tell(tab, strip);
    }

    /** Marks the shown tab's picture as old while the user's program is waited for. */
    void tellAwaited() {
        LabTab seen = pane.seen();
        boolean waits = seen.isWhole() && opening.isOwnAwaited(seen.name(), LEAST);
        Optional<LabTab> now = waits ? Optional.of(seen) : Optional.empty();
        if (now.equals(awaited)) return;
        awaited.ifPresent(before -> StageGuide.await(before.panel(), false));
        now.ifPresent(tab -> StageGuide.await(tab.panel(), true));
        awaited = now;
    }

    /** Says what can be done in the tab that is shown. */
    private void help(Language language) {
        Window window = SwingUtilities.getWindowAncestor(this);
        String stage = StageGuide.stageSeenIn(pane.seen().panel());
        HelpText help = HelpText.of(pane.seen().name(), stage, language);
        new HelpDialog(window, help).setVisible(true);
    }

    private static JLabel brand() {
        var brand = new JLabel(new BrandIcon());
        brand.setName("brand");
        brand.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 8));
        return brand;
    }

    /** A click on the tab that is shown already keeps it, whichever is coming, and its picture. */
    private final class ChoiceOfTheShownTab extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent e) {
            int clicked = pane.indexAtLocation(e.getX(), e.getY());
            if (clicked == pane.getSelectedIndex()) pane.setSelectedIndex(clicked);
            if (clicked >= 0) focusPicture();
        }
    }
}
