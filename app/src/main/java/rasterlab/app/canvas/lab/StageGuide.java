package rasterlab.app.canvas.lab;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.work.History;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Verdict;

/**
 * A stage with what is said to somebody who sees it first: over it what is special about a clicked
 * hazard, on it what to do there.
 */
public final class StageGuide extends JPanel implements HasHelp {
    private static final long serialVersionUID = 1L;

    /** View units between a stage and the sentence below it. */
    private static final int GAP = 6;

    /** Heights of a line of text that a stage needs more than the sentence needs its own place. */
    private static final int LEAST_LINES = 18;

    private final transient Texts texts;
    private final JComponent stage;
    private final HazardStrip strip;
    private final StageHint hint;
    private final OldPicture old;
    private String key = "";
    private boolean docked;

    /**
     * @param texts of this package
     * @param history remembers on which stages something was done; empty where nothing can be
     *     undone
     */
    StageGuide(JComponent stage, Texts texts, Optional<History<?>> history) {
        super(null);
        this.texts = texts;
        this.stage = stage;
        strip = new HazardStrip(texts);
        hint = new StageHint(history);
        old = new OldPicture(texts);
        setOpaque(false);
        add(old);
        add(hint);
        add(strip);
        add(stage);
    }

    /** Compares hazards with what the lab works on. */
    public StageGuide of(LabInput lab) {
        strip.of(lab);
        return this;
    }

    /**
     * Says on the stage what to do there, unless something was done already.
     *
     * @param key the same for the same stage in every language, another one in another mode
     * @param sentence "" for none
     */
    public void hint(String key, String sentence) {
        this.key = key;
        hint.show(key, sentence.isEmpty() ? "" : texts.text("hint.help", sentence));
        revalidate();
    }

    /**
     * Lays the sentence below a stage that has something to read at its lower edge, as long as that
     * leaves the stage large enough.
     */
    public StageGuide dock() {
        docked = true;
        return this;
    }

    /** Something was done on the stage: the sentence goes. */
    public void done() {
        hint.done();
    }

    void clicked(HazardCase hazard, Component chips) {
        strip.tell(hazard, chips);
        revalidate();
    }

    @Override
    public String helpKey() {
        return key;
    }

    /** The key of the stage that is seen there; "" where it has none. */
    public static String stageSeenIn(Container place) {
        for (Component child : place.getComponents()) {
            if (!child.isVisible()) continue;
            if (child instanceof HasHelp helped) return helped.helpKey();
            String found = child instanceof Container inner ? stageSeenIn(inner) : "";
            if (!found.isEmpty()) return found;
        }
        return "";
    }

    Optional<ShownHazard> shownHazard() {
        return strip.shownHazard();
    }

    void tellAgain(ShownHazard told, HazardCase words, Component chips) {
        strip.tellAgain(new ShownHazard(told.in(words), told.input(), told.before(), false), chips);
        revalidate();
    }

    /** Says over the stage of a clicked hazard that its verdicts are being found. */
    public void judging() {
        strip.judging();
        revalidate();
    }

    /** Adds the verdicts that were found for the clicked hazard of that name. */
    public void judge(String name, Map<String, Verdict.Kind> found) {
        strip.judge(name, found);
        revalidate();
    }

    /** Compares what is said with what the lab shows now. */
    public void refresh() {
        boolean before = strip.isVisible();
        strip.refresh();
        if (strip.isVisible() != before) revalidate();
    }

    /**
     * Marks what the stages there show as old, and says that the user's program is waited for; or
     * no more.
     */
    public static void await(Container place, boolean awaited) {
        for (Component child : place.getComponents())
            if (child instanceof StageGuide guide) guide.old.setVisible(awaited);
            else if (child instanceof AboutText about) about.await(awaited);
            else if (child instanceof Container inner) await(inner, awaited);
    }

    /** The guide overlaps the stage and is in no copied picture. */
    @Override
    public boolean isOptimizedDrawingEnabled() {
        return false;
    }

    @Override
    public void doLayout() {
        int high = 0;
        if (strip.isVisible()) {
            strip.setSize(getWidth(), Math.max(1, strip.getHeight()));
            high = Math.min(strip.getPreferredSize().height, getHeight() / 2);
            strip.setBounds(0, 0, getWidth(), high);
        }
        var rest = new Rectangle(0, high, getWidth(), getHeight() - high);
        hint.place(rest);
        int above = hint.getY() - GAP - rest.y;
        if (docked && hint.isVisible() && above >= least()) rest.height = above;
        stage.setBounds(rest);
        old.setBounds(rest);
    }

    /** The least height of a stage that gives room to the sentence, instead of lying below it. */
    private int least() {
        return LEAST_LINES * getFontMetrics(getFont()).getHeight();
    }

    @Override
    public Dimension getPreferredSize() {
        return stage.getPreferredSize();
    }

    @Override
    public Dimension getMinimumSize() {
        return stage.getMinimumSize();
    }
}
