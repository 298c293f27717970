package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.language.Texts;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightLabModel;

/** The selected lamp: which one, what it is, where it stands, how its light weakens. */
final class LampControls {
    /** World units from the middle along an axis. */
    static final double FAR = 400;

    /** Colours to choose from, 0xRRGGBB. */
    private static final List<Integer> COLORS =
            List.of(0xFFFFFF, 0xFFD9A0, 0x9EC9FF, 0xFF5040, 0x50E060, 0x5070FF);

    private static final int NOTCHES = 100;

    private final LightLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser lamp;
    private final JCheckBox on;
    private final NameChooser kind;
    private final NameChooser color;
    private final List<Setting> settings = new ArrayList<>();
    private boolean listing;

    private record Setting(String key, NumberSlider slider) {}

    private interface Change {
        Lamp of(Lamp lamp, double number);
    }

    LampControls(LightLabModel model, Texts texts, Inspector column) {
        this.model = model;
        this.texts = texts;
        this.column = column;
        lamp =
                new NameChooser(
                        "lamp",
                        List.of("0"),
                        index -> texts.text("lamp.number", shownNumber(index)),
                        this::select);
        column.row("lamp", lamp);
        column.wide(buttons());
        on = KeyedControls.box("lamp.on", texts, lit -> change(old -> old.switched(lit)));
        column.wide(on);
        kind =
                new NameChooser(
                        "kind",
                        Stream.of(Lamp.LampKind.values()).map(Lamp.LampKind::code).toList(),
                        code -> texts.text("kind." + code),
                        code -> change(old -> old.withKind(kind(code))));
        column.row("kind", kind);
        color =
                new NameChooser(
                        "lampColour",
                        COLORS.stream().map(LampControls::hex).toList(),
                        code -> texts.textOr("lampColour." + code, "#" + code),
                        code -> change(old -> old.colored(Integer.parseInt(code, 16))));
        column.row("lampColour", color);
        slider("strength", Lamp.FAINTEST, Lamp.STRONGEST, true, Lamp::withStrength);
        slider("x", -FAR, FAR, (old, x) -> old.moved(x, old.y(), old.z()));
        slider("y", -FAR, FAR, (old, y) -> old.moved(old.x(), y, old.z()));
        slider("z", -FAR, FAR, (old, z) -> old.moved(old.x(), old.y(), z));
        slider("constant", 0, 5, (old, c) -> old.attenuated(c, old.linear(), old.quadratic()));
        slider("linear", 0, 2, (old, l) -> old.attenuated(old.constant(), l, old.quadratic()));
        slider("quadratic", 0, 2, (old, q) -> old.attenuated(old.constant(), old.linear(), q));
        slider("cutoff", 1, 90, Lamp::withCutoff);
        slider("exponent", 0, 128, Lamp::withExponent);
    }

    private static String shownNumber(String index) {
        return Integer.toString(Integer.parseInt(index) + 1);
    }

    private static String hex(int rgb) {
        return String.format(Locale.ROOT, "%06X", rgb);
    }

    private static Lamp.LampKind kind(String code) {
        return Lamp.LampKind.valueOf(code.toUpperCase(Locale.ROOT));
    }

    private JPanel buttons() {
        var buttons = new JPanel(new MigLayout("insets 0, gap 6", "[grow,fill,sg][grow,fill,sg]"));
        buttons.add(button("grow", () -> model.choose(LightChoice::grown)), "wmin 0");
        buttons.add(button("shrink", () -> model.choose(LightChoice::shrunk)), "wmin 0");
        return buttons;
    }

    private JButton button(String key, Runnable action) {
        return KeyedControls.button(key, texts, action);
    }

    private void select(String index) {
        if (!listing) model.choose(choice -> choice.selecting(Integer.parseInt(index)));
    }

    /** Lists as many entries as there are lamps. */
    private void list(int lamps) {
        listing = true;
        while (lamp.getItemCount() > lamps) lamp.removeItemAt(lamp.getItemCount() - 1);
        while (lamp.getItemCount() < lamps) lamp.addItem(Integer.toString(lamp.getItemCount()));
        listing = false;
    }

    private void change(UnaryOperator<Lamp> change) {
        model.choose(choice -> choice.withLamp(change.apply(choice.lamp())));
    }

    private void slider(String key, double least, double most, Change change) {
        slider(key, least, most, false, change);
    }

    private void slider(String key, double least, double most, boolean logarithmic, Change change) {
        var slider =
                new NumberSlider(
                        key,
                        texts.text(key + ".hint"),
                        least,
                        most,
                        logarithmic,
                        NOTCHES,
                        number -> change(old -> change.of(old, number)));
        column.row(key, slider);
        settings.add(new Setting(key, slider));
    }

    void refresh() {
        LightChoice choice = model.state().choice();
        Lamp now = choice.lamp();
        list(choice.lamps().size());
        lamp.show(Integer.toString(choice.selected()));
        on.setSelected(now.on());
        kind.show(now.kind().code());
        color.show(hex(now.rgb()));
        boolean sun = now.kind() == Lamp.LampKind.SUN;
        boolean spot = now.kind() == Lamp.LampKind.SPOT;
        for (Setting each : settings) {
            double value = value(now, each.key());
            each.slider().show(value, coordinateText(now, each.key(), value));
            boolean attenuates = List.of("constant", "linear", "quadratic").contains(each.key());
            boolean gathers = List.of("cutoff", "exponent").contains(each.key());
            column.showRow(each.slider(), !(attenuates && sun) && (!gathers || spot));
        }
    }

    /** A coordinate beside the lamp's others. */
    private String coordinateText(Lamp lamp, String key, double value) {
        double largest =
                List.of("x", "y", "z").contains(key)
                        ? Math.max(
                                Math.abs(lamp.x()),
                                Math.max(Math.abs(lamp.y()), Math.abs(lamp.z())))
                        : value;
        return Shown.coordinate(value, largest, 2, texts.locale());
    }

    private static double value(Lamp lamp, String key) {
        return switch (key) {
            case "strength" -> lamp.strength();
            case "x" -> lamp.x();
            case "y" -> lamp.y();
            case "z" -> lamp.z();
            case "constant" -> lamp.constant();
            case "linear" -> lamp.linear();
            case "quadratic" -> lamp.quadratic();
            case "cutoff" -> lamp.cutoff();
            default -> lamp.exponent();
        };
    }
}
