package rasterlab.app.canvas.player;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.language.Texts;

/** The timeline below the stage: to the start, back, play, step, to the end, position, speed. */
public final class StepPlayer extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Slowest and fastest speed, in powers of two steps a second: 1 to 64. */
    private static final int FASTEST = 6;

    private final transient Steps steps;
    private final transient Texts texts;
    private final transient Supplier<String> reading;
    private final JPanel buttons = new JPanel(new MigLayout("insets 0, gap 4", "", "[center]"));
    private final JButton toStart;
    private final JButton back;
    private final JButton play;
    private final JButton forward;
    private final JButton toEnd;
    private final JSlider position = new JSlider();
    private final JSlider speed = new JSlider(0, FASTEST, 3);
    private final SteadyLabel count = new SteadyLabel();
    private final Timer timer = new Timer(1000, this::advance);
    private boolean refreshing;
    private transient Runnable onUse = () -> {};

    /**
     * @param texts of this package
     * @param reading what stands beside the position, such as "3 / 12"
     */
    public StepPlayer(Texts texts, Steps steps, Supplier<String> reading) {
        super(new PlayerRows(16));
        FlowRows.keepWrapped(this);
        this.steps = steps;
        this.texts = texts;
        this.reading = reading;
        toStart = button("toStart", PlayerIcon.TO_START, () -> go(steps.first()));
        back = button("back", PlayerIcon.BACK, () -> go(steps.after(-1)));
        play = button("play", PlayerIcon.PLAY, this::togglePlaying);
        forward = button("forward", PlayerIcon.FORWARD, () -> go(steps.after(1)));
        toEnd = button("toEnd", PlayerIcon.TO_END, () -> go(steps.last()));
        add(buttons);
        addPosition();
        addSpeed();
        setPace();
        refresh();
    }

    /** Shows where the steps stand now. */
    public void refresh() {
        refreshing = true;
        position.setMinimum(steps.first());
        position.setMaximum(steps.last());
        position.setValue(steps.step());
        refreshing = false;
        boolean any = steps.last() > steps.first();
        toStart.setEnabled(steps.step() > steps.first());
        back.setEnabled(steps.after(-1) != steps.step());
        forward.setEnabled(steps.after(1) != steps.step());
        toEnd.setEnabled(steps.step() < steps.last());
        play.setEnabled(any);
        position.setEnabled(any);
        count.show(reading.get(), steps.last());
        if (!any) stop();
    }

    /** Keeps room beside the position for a text that may come to stand there. */
    public void reserve(String longest) {
        count.reserve(longest);
    }

    /** Lets the keys that the hints name work while that component has the focus. */
    public void bindKeys(JComponent stage) {
        for (KeyStroke key : keys()) KeyBinding.within(stage, key, () -> press(key));
    }

    /** The keys that the hints name. */
    public static List<KeyStroke> keys() {
        return Stream.of("SPACE", "PAGE_UP", "PAGE_DOWN", "HOME", "END")
                .map(KeyStroke::getKeyStroke)
                .toList();
    }

    /** Does what one of the {@link #keys} means. */
    public void press(KeyStroke key) {
        switch (key.getKeyCode()) {
            case KeyEvent.VK_SPACE -> togglePlaying();
            case KeyEvent.VK_PAGE_UP -> go(steps.after(-1));
            case KeyEvent.VK_PAGE_DOWN -> go(steps.after(1));
            case KeyEvent.VK_HOME -> go(steps.first());
            case KeyEvent.VK_END -> go(steps.last());
            default -> throw new IllegalArgumentException("no key of the player: " + key);
        }
    }

    /** Runs it whenever the user steps or plays. */
    public void whenUsed(Runnable told) {
        onUse = told;
    }

    /** Plays from where it stands, from the first step when it stands at the last; or stops. */
    public void togglePlaying() {
        onUse.run();
        if (timer.isRunning()) {
            stop();
            return;
        }
        if (steps.step() == steps.last()) steps.goTo(steps.first());
        timer.start();
        showPlaying();
    }

    public void stop() {
        boolean played = timer.isRunning();
        timer.stop();
        showPlaying();
        if (played) steps.rest();
    }

    /**
     * Takes one step for the user, after which others follow while it plays or the slider is held.
     */
    private void go(int step) {
        onUse.run();
        steps.goTo(step);
        if (!timer.isRunning() && !position.getValueIsAdjusting()) steps.rest();
    }

    /** How it plays, for the player that comes after it. */
    public record Playing(boolean on, int speed) {}

    public Playing playing() {
        return new Playing(timer.isRunning(), speed.getValue());
    }

    /** Plays, or does not, as the player did that was there before, from where the steps stand. */
    public void goOn(Playing before) {
        speed.setValue(before.speed());
        if (before.on()) timer.start();
        else timer.stop();
        showPlaying();
    }

    /** The player that is seen in that window or part of it; empty where there is none. */
    public static Optional<StepPlayer> seenIn(Container place) {
        for (Component child : place.getComponents()) {
            if (!child.isVisible()) continue;
            if (child instanceof StepPlayer player) return Optional.of(player);
            if (child instanceof Container inner) {
                Optional<StepPlayer> found = seenIn(inner);
                if (found.isPresent()) return found;
            }
        }
        return Optional.empty();
    }

    private void advance(ActionEvent tick) {
        steps.goTo(steps.after(1));
        if (steps.step() == steps.last() && !steps.turnsRound()) stop();
    }

    private void showPlaying() {
        boolean playing = timer.isRunning();
        play.setIcon(playing ? PlayerIcon.PAUSE.icon() : PlayerIcon.PLAY.icon());
        name(play, playing ? "player.pause" : "player.play");
    }

    private JButton button(String key, PlayerIcon icon, Runnable action) {
        var button = new JButton(icon.icon());
        button.setName("player." + key);
        name(button, "player." + key);
        button.addActionListener(e -> action.run());
        buttons.add(button);
        return button;
    }

    private void name(JComponent component, String key) {
        component.setToolTipText(texts.text(key));
        component.getAccessibleContext().setAccessibleName(texts.text(key));
    }

    private void addPosition() {
        position.setName("player.position");
        name(position, "player.position");
        position.addChangeListener(
                e -> {
                    if (!refreshing) go(position.getValue());
                });
        var place = new JPanel(new MigLayout("insets 0, gap 8", "[grow,fill][]", "[center]"));
        place.add(position, "wmin 60");
        count.setName("player.count");
        place.add(count);
        add(place);
    }

    private void addSpeed() {
        var label = new JLabel(texts.text("player.speed"));
        label.setLabelFor(speed);
        speed.setName("player.speed");
        name(speed, "player.speed.hint");
        speed.setSnapToTicks(true);
        speed.addChangeListener(e -> setPace());
        var pace = new JPanel(new MigLayout("insets 0, gap 4", "[][]", "[center]"));
        pace.add(label);
        pace.add(speed, "w 90!");
        add(pace);
    }

    private void setPace() {
        int millis = 1000 >> speed.getValue();
        timer.setDelay(millis);
        timer.setInitialDelay(millis);
    }
}
