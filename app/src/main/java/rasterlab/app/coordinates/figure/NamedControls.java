package rasterlab.app.coordinates.figure;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** Controls of an inspector, named and said by their key. */
public final class NamedControls {
    private final Inspector column;
    private final Texts texts;

    public NamedControls(Inspector column, Texts texts) {
        this.column = column;
        this.texts = texts;
    }

    /** A list of names, each said as {@code KEY.NAME}. */
    public NameChooser names(String key, List<String> names, Consumer<String> chosen) {
        var chooser = new NameChooser(key, names, name -> texts.text(key + "." + name), chosen);
        chooser.setMaximumRowCount(24);
        column.row(key, chooser);
        return chooser;
    }

    /** The row in which a method is chosen. */
    public MethodChooser method(List<? extends Method<?>> methods, Consumer<String> chosen) {
        List<String> names = methods.stream().map(Method::name).toList();
        var chooser = new MethodChooser("method", "", names, FigureColors.OWN, chosen);
        column.row("method", chooser);
        return chooser;
    }

    /**
     * Rows of numbers across the column.
     *
     * @param heading the key of the heading above, by which assistive technology names them
     */
    public NumberTable table(String heading) {
        var table = new NumberTable("table", texts.text(heading));
        column.wide(table);
        return table;
    }

    /** The text about a method, under its heading. */
    public AboutText about() {
        column.heading("heading.about");
        var about = new AboutText("about", texts.language());
        column.wide(about);
        return about;
    }

    /** A number, explained by {@code KEY.hint}. */
    public SliderField number(String key, SliderField.Range range, DoubleConsumer changed) {
        var field = new SliderField(key, texts.text(key + ".hint"), range, texts.locale(), changed);
        column.row(key, field);
        return field;
    }

    /** A check box across the column. */
    public JCheckBox box(String key, Consumer<Boolean> chosen) {
        JCheckBox box = KeyedControls.box(key, texts, chosen);
        column.wide(box);
        return box;
    }

    /** A button that is not placed yet. */
    public JButton button(String key, Runnable action) {
        return KeyedControls.button(key, texts, action);
    }
}
