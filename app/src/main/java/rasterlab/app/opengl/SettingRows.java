package rasterlab.app.opengl;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.EnumMap;
import java.util.Map;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.texture.Texture;

/** A drop-down list for each setting, of which those of one group are seen. */
final class SettingRows {
    private final OpenGlLabModel model;
    private final Texts texts;
    private final Map<Setting, NameChooser> choosers = new EnumMap<>(Setting.class);
    private final Inspector column;
    private final Runnable onFile;

    /**
     * @param onFile asks the user for an image file
     */
    SettingRows(OpenGlLabModel model, Texts texts, Inspector column, Runnable onFile) {
        this.onFile = onFile;
        this.model = model;
        this.texts = texts;
        this.column = column;
    }

    /** Adds the lists of one group. */
    void add(Group group) {
        group.settings().forEach(this::add);
    }

    private void add(Setting setting) {
        var chooser =
                new NameChooser(
                        setting.code(),
                        setting.options(),
                        option -> optionText(setting, option),
                        option -> choose(setting, option));
        // A light pop-up would be hidden by OpenGL's window.
        chooser.setLightWeightPopupEnabled(false);
        chooser.setToolTipText(setting.call());
        chooser.addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        model.touch(setting);
                    }
                });
        choosers.put(setting, chooser);
        column.row("setting." + setting.code(), chooser);
    }

    /** An image file has to be opened before it can be chosen. */
    private void choose(Setting setting, String option) {
        boolean file = setting == Setting.IMAGE && option.equals("file");
        if (!file || model.state().choice().file().isPresent()) model.set(setting, option);
        else onFile.run();
    }

    /** OpenGL's names and numbers as they are, other words in the window's language. */
    private String optionText(Setting setting, String option) {
        if (setting == Setting.SIZE && ofFile()) return ownSize();
        if (setting == Setting.IMAGE && option.equals("file") && ofFile())
            return texts.text("option.image.file.named", fileName());
        String key = "option." + setting.code() + "." + option.replace(':', '-');
        if (texts.has(key)) return texts.text(key);
        return texts.textOr("option." + option, option.replace(":", ", "));
    }

    /** Whether the texture is an image of the user's, whatever size the lab's own would have. */
    private boolean ofFile() {
        return model.state().choice().is(Setting.IMAGE, "file");
    }

    private String fileName() {
        return model.state().choice().file().orElseThrow().name();
    }

    private String ownSize() {
        Texture image = model.state().choice().file().orElseThrow().texture();
        return image.width() + " × " + image.height();
    }

    /** Shows the present options, of one group only. */
    void refresh(Group group) {
        choosers.forEach(
                (setting, chooser) -> {
                    boolean shown = setting.group() == group;
                    if (chooser.isVisible() != shown) column.showRow(chooser, shown);
                    chooser.show(model.state().choice().get(setting));
                    if (setting == Setting.IMAGE) chooser.repaint();
                    if (setting == Setting.SIZE) {
                        chooser.setEnabled(!ofFile());
                        chooser.repaint();
                    }
                });
    }
}
