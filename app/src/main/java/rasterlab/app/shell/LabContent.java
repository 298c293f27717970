package rasterlab.app.shell;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * What the frame holds: the tabs, and the choice of language and theme at the end of their strip.
 */
public final class LabContent extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JTabbedPane pane = new JTabbedPane();
    private final transient List<LabTab> tabs;

    /**
     * @param shown name of the tab to show; an unknown one is the first
     * @param onLanguage told the language that the user chooses
     * @param onTheme told the theme that the user chooses
     */
    public LabContent(
            LabTabs labs,
            String shown,
            LabTheme theme,
            Consumer<Language> onLanguage,
            Consumer<LabTheme> onTheme) {
        super(new BorderLayout());
        Texts texts = Texts.of("shell", labs.language());
        tabs = labs.all();
        pane.setName("tabs");
        pane.getAccessibleContext().setAccessibleName(texts.text("tabs"));
        pane.putClientProperty("JTabbedPane.tabHeight", 40);
        pane.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        for (Component part : pane.getComponents())
            if (part instanceof JViewport strip) strip.setFocusable(false);
        for (LabTab tab : tabs) {
            int digit = (pane.getTabCount() + 1) % 10;
            pane.addTab(
                    tab.title(),
                    null,
                    new JPanel(new BorderLayout()),
                    texts.text("tab.tip", digit));
            pane.setMnemonicAt(pane.getTabCount() - 1, KeyEvent.VK_0 + digit);
        }
        labs.opening().showTabsBy(this::show);
        show(shown);
        fill();
        pane.putClientProperty("JTabbedPane.leadingComponent", brand());
        pane.putClientProperty(
                "JTabbedPane.trailingComponent", choices(texts, theme, onLanguage, onTheme));
        add(pane);
        pane.addChangeListener(
                e -> {
                    fill();
                    focusPicture();
                });
        pane.addMouseListener(new ChoiceOfTheShownTab());
    }

    /** Makes the panel of the tab that is shown, unless it is there. */
    private void fill() {
        var place = (JPanel) pane.getSelectedComponent();
        if (place.getComponentCount() == 0) place.add(tabs.get(pane.getSelectedIndex()).panel());
        place.revalidate();
    }

    /**
     * Gives the keyboard to the picture of the tab that is shown. Asked twice, since Swing moves
     * the focus out of what was hidden by itself, and sometimes later than it is first asked.
     */
    void focusPicture() {
        Runnable give = () -> tabs.get(pane.getSelectedIndex()).panel().focusPicture();
        give.run();
        EventQueue.invokeLater(give);
    }

    /** Name of the tab that is shown. */
    public String shown() {
        return tabs.get(pane.getSelectedIndex()).name();
    }

    /** Shows the tab of that name; an unknown name leaves the one that is shown. */
    public void show(String tab) {
        for (int i = 0; i < tabs.size(); i++)
            if (tabs.get(i).name().equals(tab)) pane.setSelectedIndex(i);
    }

    private static JLabel brand() {
        var brand = new JLabel("Rasterlab", new BrandIcon(), JLabel.LEADING);
        brand.setName("brand");
        brand.setFont(brand.getFont().deriveFont(Font.BOLD, brand.getFont().getSize2D() + 2));
        brand.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 16));
        return brand;
    }

    private static JPanel choices(
            Texts texts,
            LabTheme theme,
            Consumer<Language> onLanguage,
            Consumer<LabTheme> onTheme) {
        var language = new JComboBox<String>();
        for (Language each : Language.values()) language.addItem(each.ownName());
        language.setSelectedIndex(texts.language().ordinal());
        language.setName("language");
        language.getAccessibleContext().setAccessibleName(texts.text("language"));
        language.setToolTipText(texts.text("language"));
        language.addActionListener(
                e -> onLanguage.accept(Language.values()[language.getSelectedIndex()]));

        String key = theme == LabTheme.LIGHT ? "theme.dark" : "theme.light";
        var toggle = new JButton(texts.label(key), new ThemeIcon(theme.other()));
        toggle.setName("theme");
        toggle.setMnemonic(texts.mnemonic(key));
        toggle.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        toggle.addActionListener(e -> onTheme.accept(theme.other()));

        var panel =
                new JPanel(new MigLayout("insets 0 0 0 10, gap 8", "push[][]", "[center,grow]"));
        panel.setOpaque(false);
        panel.add(language);
        panel.add(toggle);
        return panel;
    }

    /** A click on the tab that is shown already changes nothing, but chooses its picture too. */
    private final class ChoiceOfTheShownTab extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent e) {
            if (pane.indexAtLocation(e.getX(), e.getY()) >= 0) focusPicture();
        }
    }
}
