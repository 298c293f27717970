package rasterlab.app.shell;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import rasterlab.app.language.Texts;

/**
 * The labs' tabs, whose panels are made when they are first chosen. In an open window each is
 * prepared in the background, then made, laid out and shown in an event each, between which the
 * window answers; until then it shows the tab before.
 */
final class TabbedLabs extends JTabbedPane {
    private static final long serialVersionUID = 1L;

    private final transient List<LabTab> tabs;

    /** The tab that is shown, or will be once it is made. */
    private int chosen;

    TabbedLabs(List<LabTab> tabs, Texts texts) {
        this.tabs = tabs;
        setName("tabs");
        getAccessibleContext().setAccessibleName(texts.text("tabs"));
        putClientProperty("JTabbedPane.tabHeight", 40);
        setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        TitlesInSight.keep(this);
        for (LabTab tab : tabs) {
            int digit = (getTabCount() + 1) % 10;
            addTab(tab.title(), null, new JPanel(new BorderLayout()), texts.text("tab.tip", digit));
            setMnemonicAt(getTabCount() - 1, KeyEvent.VK_0 + digit);
        }
    }

    /** The tab that is shown, or about to be. */
    LabTab chosen() {
        return tabs.get(chosen);
    }

    /** The tab that is shown. */
    LabTab seen() {
        return tabs.get(getSelectedIndex());
    }

    /** Gives the keyboard to the picture of the tab that is shown, unless another is coming. */
    void focusPicture() {
        if (chosen == getSelectedIndex()) chosen().panel().focusPicture();
    }

    /** Shows the tab of that name; an unknown name leaves the one that is shown. */
    void show(String tab) {
        for (int i = 0; i < tabs.size(); i++)
            if (tabs.get(i).name().equals(tab)) setSelectedIndex(i);
    }

    /** Makes the panel of the tab that is shown, unless it is there. */
    void fill() {
        fill(getSelectedIndex());
    }

    private void fill(int index) {
        JPanel place = place(index);
        if (place.getComponentCount() == 0) place.add(tabs.get(index).panel());
        place.revalidate();
    }

    private JPanel place(int index) {
        return (JPanel) getComponentAt(index);
    }

    @Override
    public void setSelectedIndex(int index) {
        chosen = index;
        if (!isShowing() || place(index).getComponentCount() > 0) super.setSelectedIndex(index);
        else
            tabs.get(index)
                    .preparation()
                    .ifPresentOrElse(
                            preparation -> prepare(index, preparation),
                            () -> later(index, () -> make(index)));
    }

    /** What fails here fails again where the panel is made. */
    private void prepare(int index, Runnable preparation) {
        CompletableFuture.runAsync(preparation, work -> new Thread(work, "tab").start())
                .whenComplete((done, failure) -> later(index, () -> make(index)));
    }

    private void make(int index) {
        fill(index);
        later(index, () -> layOut(index));
    }

    private void layOut(int index) {
        JPanel place = place(index);
        place.setBounds(getSelectedComponent().getBounds());
        place.validate();
        later(index, () -> setSelectedIndex(index));
    }

    /** In the next event, unless another tab was chosen or the window changed all till then. */
    private void later(int index, Runnable step) {
        EventQueue.invokeLater(
                () -> {
                    if (chosen == index && isShowing()) step.run();
                });
    }
}
