package rasterlab.app.shell;

import java.awt.event.ActionEvent;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The choice of language, theme and size of type, at the end of the strip of tabs. */
final class LookControls extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient LabLook look;
    private final transient Consumer<LabLook> onLook;

    LookControls(Texts texts, LabLook look, Consumer<LabLook> onLook) {
        super(new MigLayout("insets 0 8 0 10, gap 8", "push[][]", "[center,grow]"));
        this.texts = texts;
        this.look = look;
        this.onLook = onLook;
        setOpaque(false);
        add(language());
        add(button());
        bindKey("ctrl EQUALS", "larger", look::larger);
        bindKey("ctrl PLUS", "larger", look::larger);
        bindKey("ctrl ADD", "larger", look::larger);
        bindKey("ctrl MINUS", "smaller", look::smaller);
        bindKey("ctrl SUBTRACT", "smaller", look::smaller);
        bindKey("ctrl 0", "usual", look::usualSize);
        bindKey("ctrl NUMPAD0", "usual", look::usualSize);
    }

    private JComboBox<String> language() {
        var language = new JComboBox<String>();
        for (Language each : Language.values()) language.addItem(each.ownName());
        language.setSelectedIndex(look.language().ordinal());
        language.setName("language");
        language.getAccessibleContext().setAccessibleName(texts.text("language"));
        language.setToolTipText(texts.text("language"));
        language.addActionListener(
                e -> onLook.accept(look.with(Language.values()[language.getSelectedIndex()])));
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
        bind("F10", "look", open);
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
        menu.add(size("larger", "ctrl EQUALS", look::larger));
        menu.add(size("smaller", "ctrl MINUS", look::smaller));
        menu.add(size("usual", "ctrl 0", look::usualSize));
        return menu;
    }

    private JMenuItem size(String name, String keys, Supplier<LabLook> next) {
        var item = new JMenuItem(texts.text("text." + name));
        item.setName("text." + name);
        item.setAccelerator(KeyStroke.getKeyStroke(keys));
        item.setEnabled(!next.get().equals(look));
        item.addActionListener(e -> onLook.accept(next.get()));
        return item;
    }

    private void bindKey(String keys, String name, Supplier<LabLook> next) {
        bind(keys, "text." + name, () -> onLook.accept(next.get()));
    }

    private void bind(String keys, String name, Runnable action) {
        getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(keys), name);
        getActionMap()
                .put(
                        name,
                        new AbstractAction() {
                            private static final long serialVersionUID = 1L;

                            @Override
                            public void actionPerformed(ActionEvent e) {
                                action.run();
                            }
                        });
    }
}
