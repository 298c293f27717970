package rasterlab.app.shell;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.WindowKeys;

/** The choice of language, theme and size of type, at the end of the strip of tabs. */
final class WindowLookControls extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient LabLook look;
    private final transient WindowKeys keys;
    private final transient Consumer<LabLook> onLook;
    private final transient Consumer<Language> onLanguage;
    private final transient Runnable onHelp;

    /**
     * @param keys given the keys of the choice
     * @param onHelp asked what can be done in the tab
     */
    WindowLookControls(
            Texts texts,
            LabLook look,
            WindowKeys keys,
            Consumer<LabLook> onLook,
            Consumer<Language> onLanguage,
            Runnable onHelp) {
        super(new MigLayout("insets 0 8 0 10, gap 8", "push[][]", "[center,grow]"));
        this.texts = texts;
        this.look = look;
        this.keys = keys;
        this.onLook = onLook;
        this.onLanguage = onLanguage;
        this.onHelp = onHelp;
        setOpaque(false);
        add(language());
        add(button());
        bindSize(
                List.of("ctrl EQUALS", "ctrl shift EQUALS", "ctrl PLUS", "ctrl ADD"), look::larger);
        bindSize(List.of("ctrl MINUS", "ctrl SUBTRACT"), look::smaller);
        bindSize(List.of("ctrl 0", "ctrl NUMPAD0"), look::usualSize);
    }

    private JComboBox<String> language() {
        var language = new JComboBox<String>();
        for (Language each : Language.values()) language.addItem(each.ownName());
        language.setSelectedIndex(look.language().ordinal());
        language.setName("language");
        language.getAccessibleContext().setAccessibleName(texts.text("language"));
        language.setToolTipText(texts.text("language"));
        language.addActionListener(
                e -> onLanguage.accept(Language.values()[language.getSelectedIndex()]));
        return language;
    }

    private JButton button() {
        var button = new JButton(new ThemeIcon(look.theme()));
        button.setName("look");
        button.setToolTipText(texts.text("look.tip"));
        button.getAccessibleContext().setAccessibleName(texts.text("look"));
        JPopupMenu menu = menu();
        Runnable open =
                () ->
                        menu.show(
                                button,
                                button.getWidth() - menu.getPreferredSize().width,
                                button.getHeight());
        button.addActionListener(e -> open.run());
        keys.bind(KeyStroke.getKeyStroke("F10"), open);
        return button;
    }

    private JPopupMenu menu() {
        var menu = new JPopupMenu();
        menu.setName("look.menu");
        var group = new ButtonGroup();
        for (LabTheme each : LabTheme.values()) {
            String key = "theme." + each.name().toLowerCase(Locale.ROOT);
            var item = new JRadioButtonMenuItem(texts.text(key), each == look.theme());
            item.setName(key);
            item.addActionListener(e -> onLook.accept(look.with(each)));
            group.add(item);
            menu.add(item);
        }
        menu.addSeparator();
        // The menu shows the signs on the keys; bindSize binds the keys themselves.
        menu.add(size("larger", "ctrl typed +", look::larger));
        menu.add(size("smaller", "ctrl typed −", look::smaller));
        menu.add(size("usual", "ctrl 0", look::usualSize));
        menu.addSeparator();
        menu.add(help());
        return menu;
    }

    private JMenuItem help() {
        var item = new JMenuItem(texts.text("help"));
        item.setName("help.open");
        item.setAccelerator(KeyStroke.getKeyStroke("F1"));
        item.addActionListener(e -> onHelp.run());
        return item;
    }

    private JMenuItem size(String name, String keys, Supplier<LabLook> next) {
        var item = new JMenuItem(texts.text("text." + name));
        item.setName("text." + name);
        item.setAccelerator(KeyStroke.getKeyStroke(keys));
        item.setEnabled(!next.get().equals(look));
        item.addActionListener(e -> onLook.accept(next.get()));
        return item;
    }

    private void bindSize(List<String> strokes, Supplier<LabLook> next) {
        for (String stroke : strokes)
            keys.bind(KeyStroke.getKeyStroke(stroke), () -> onLook.accept(next.get()));
    }
}
