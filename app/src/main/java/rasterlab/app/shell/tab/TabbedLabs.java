package rasterlab.app.shell.tab;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StepQuestions;
import rasterlab.app.language.Texts;
import rasterlab.engine.naming.Named;

/**
 * The labs' tabs, whose panels are made when they are first chosen. In an open window each is
 * prepared in the background, then made part by part, put in place, laid out and shown in several
 * events, between which the window answers; until then it shows the tab before.
 */
public final class TabbedLabs extends JTabbedPane {
    private static final long serialVersionUID = 1L;

    private final transient List<LabTab> tabs;
    private final transient Consumer<Throwable> onFailure;

    /** The tab that is shown, or will be once it is made. */
    private int chosen;

    /**
     * @param onFailure told why a panel could not be made; another choice of its tab tries again
     */
    public TabbedLabs(List<LabTab> tabs, Consumer<Throwable> onFailure, Texts texts) {
        this.tabs = tabs;
        this.onFailure = onFailure;
        setName("tabs");
        getAccessibleContext().setAccessibleName(texts.text("tabs"));
        for (LabTab tab : tabs) {
            int digit = (getTabCount() + 1) % 10;
            addTab(tab.title(), null, new JPanel(new BorderLayout()), texts.text("tab.tip", digit));
            setMnemonicAt(getTabCount() - 1, KeyEvent.VK_0 + digit);
        }
        // These are the look and feel's names for the arrow keys on the strip of tabs.
        getActionMap().put("navigateRight", stepping(1));
        getActionMap().put("navigateLeft", stepping(-1));
    }

    @Override
    public void updateUI() {
        setUI(new TabRows());
    }

    @Override
    public void doLayout() {
        TitleType.fit(this);
        super.doLayout();
    }

    private Action stepping(int by) {
        return new AbstractAction() {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                step(by);
            }
        };
    }

    /** Counts from the tab that is chosen: keys are pressed faster than tabs are made. */
    private void step(int by) {
        setSelectedIndex(Math.floorMod(chosen + by, tabs.size()));
    }

    /** Gives the keys that step through the tabs to the window, whatever has the keyboard. */
    public void bindSteps(WindowKeys keys) {
        keys.bind(KeyStroke.getKeyStroke("ctrl TAB"), () -> step(1));
        keys.bind(KeyStroke.getKeyStroke("ctrl PAGE_DOWN"), () -> step(1));
        keys.bind(KeyStroke.getKeyStroke("ctrl shift TAB"), () -> step(-1));
        keys.bind(KeyStroke.getKeyStroke("ctrl PAGE_UP"), () -> step(-1));
    }

    /** The tab that is shown, or about to be. */
    public LabTab chosen() {
        return tabs.get(chosen);
    }

    /** The tab that is shown. */
    public LabTab seen() {
        return tabs.get(getSelectedIndex());
    }

    /** Gives the keyboard to the picture of the tab that is shown, unless another is coming. */
    public void focusPicture() {
        if (chosen == getSelectedIndex() && isMade(chosen)) chosen().panel().focusPicture();
    }

    /** Shows the tab of that name; an unknown name leaves the one that is shown. */
    public void show(String tab) {
        for (int i = 0; i < tabs.size(); i++)
            if (tabs.get(i).name().equals(tab)) setSelectedIndex(i);
    }

    /** Makes the panel of the tab that is shown, unless it is there. */
    public void fill() {
        attempt(() -> fill(getSelectedIndex()));
    }

    private void fill(int index) {
        JPanel place = place(index);
        if (!isMade(index)) {
            LabPanel lab = tabs.get(index).panel();
            lab.addPropertyChangeListener(StepQuestions.ASKING, e -> fitWords(index));
            place.add(lab, BorderLayout.CENTER);
            fitWords(index);
        }
        place.revalidate();
    }

    private boolean isMade(int index) {
        return part(index, BorderLayout.CENTER).isPresent();
    }

    private Optional<Component> part(int index, String where) {
        var layout = (BorderLayout) place(index).getLayout();
        return Optional.ofNullable(layout.getLayoutComponent(where));
    }

    /** Puts words over the lab of a tab, in place of those that are there. */
    public void tell(String tab, JComponent words) {
        tellNothing(tab);
        JPanel place = place(indexOf(tab));
        place.add(words, BorderLayout.NORTH);
        fitWords(indexOf(tab));
        place.revalidate();
    }

    /** Words over a lab are about the lab, not about questions that are asked in its place. */
    private void fitWords(int index) {
        boolean asking =
                part(index, BorderLayout.CENTER)
                        .filter(lab -> lab instanceof StepQuestions place && place.isAsking())
                        .isPresent();
        part(index, BorderLayout.NORTH).ifPresent(words -> words.setVisible(!asking));
    }

    /** Takes the words away that are over the lab of a tab. */
    public void tellNothing(String tab) {
        int index = indexOf(tab);
        JPanel place = place(index);
        part(index, BorderLayout.NORTH).ifPresent(place::remove);
        place.revalidate();
        place.repaint();
    }

    /** Takes away what is said over the lab of a tab about the user's program. */
    public void tellNoOwn(String tab) {
        if (part(indexOf(tab), BorderLayout.NORTH).filter(OwnStrip.class::isInstance).isPresent())
            tellNothing(tab);
    }

    private int indexOf(String tab) {
        return tabs.indexOf(Named.find("tab", tab, tabs, LabTab::name));
    }

    /** Runs a step; where it fails, the tab that is seen stays the chosen one. */
    private void attempt(Runnable step) {
        try {
            step.run();
        } catch (RuntimeException | LinkageError | AssertionError e) {
            chosen = getSelectedIndex();
            onFailure.accept(e);
        }
    }

    private JPanel place(int index) {
        return (JPanel) getComponentAt(index);
    }

    @Override
    public void setSelectedIndex(int index) {
        chosen = index;
        if (!isShowing() || isMade(index)) super.setSelectedIndex(index);
        else prepare(index);
    }

    /** Prepares a panel; a failure here comes again where the panel is made. */
    private void prepare(int index) {
        CompletableFuture.runAsync(
                        tabs.get(index).preparation(), work -> new Thread(work, "tab").start())
                .whenComplete((done, failure) -> later(index, () -> make(index)));
    }

    /** Makes it part by part; then does what shows the panel. */
    private void make(int index) {
        LabTab tab = tabs.get(index);
        if (tab.isWhole()) later(index, () -> show(index));
        else
            later(
                    index,
                    () -> {
                        // A tab that was chosen again meanwhile is made by both choices in turn.
                        if (!tab.isWhole()) tab.makePart();
                        make(index);
                    });
    }

    /** Puts a panel that is whole in place, and shows it when it is laid out. */
    private void show(int index) {
        fill(index);
        JPanel place = place(index);
        place.setBounds(getSelectedComponent().getBounds());
        var steps = new ArrayList<>(LayoutParts.of(place));
        steps.add(() -> setSelectedIndex(index));
        inTurn(index, steps);
    }

    /** Runs each in an event of its own, after this one. */
    private void inTurn(int index, List<Runnable> steps) {
        if (steps.isEmpty()) return;
        later(
                index,
                () -> {
                    steps.get(0).run();
                    inTurn(index, steps.subList(1, steps.size()));
                });
    }

    /**
     * Runs a step in the next event, unless another tab was chosen or the window changed all till
     * then.
     */
    private void later(int index, Runnable step) {
        EventQueue.invokeLater(
                () -> {
                    if (chosen == index && isShowing()) attempt(step);
                });
    }
}
