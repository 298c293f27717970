package rasterlab.app.polygon;

import java.util.List;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.BrushKind;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.contract.FillRule;

/**
 * The controls that only the figure of one mode has: whole numbers, fill rule, brush, neighbours,
 * colour.
 */
final class FigureControls {
    private final JCheckBox whole;
    private final NameChooser rule;
    private final NameChooser brush;
    private final NameChooser connectivity;
    private final NameChooser color;

    FigureControls(PolygonLabModel model, Texts texts, Inspector column) {
        whole = KeyedControls.box("whole", texts, on -> model.inside(old -> old.withWhole(on)));
        column.wide(whole);
        rule =
                new NameChooser(
                        "rule",
                        Stream.of(FillRule.values()).map(FillRule::name).toList(),
                        name -> texts.text("rule." + name),
                        name -> model.fill(old -> old.withRule(FillRule.valueOf(name))));
        column.row("rule", rule);
        brush =
                new NameChooser(
                        "brush",
                        Stream.of(BrushKind.values()).map(BrushKind::code).toList(),
                        name -> texts.text("brush." + name),
                        name -> model.fill(old -> old.withBrush(BrushKind.coded(name))));
        column.row("brush", brush);
        connectivity =
                new NameChooser(
                        "connectivity",
                        List.of("4", "8", "6"),
                        name -> texts.text("connectivity." + name),
                        name -> model.seed(old -> old.withConnectivity(Integer.parseInt(name))));
        column.row("connectivity", connectivity);
        color =
                new NameChooser(
                        "colour",
                        List.of("new", "same"),
                        name -> texts.text("colour." + name),
                        name -> model.seed(old -> old.withSame(name.equals("same"))));
        column.row("colour", color);
    }

    void refresh(PolygonFigure figure, Inspector column) {
        whole.setVisible(figure instanceof InsideFigure);
        if (figure instanceof InsideFigure inside) whole.setSelected(inside.whole());
        boolean fill = figure instanceof FillFigure;
        column.showRow(rule, fill);
        column.showRow(brush, fill);
        if (figure instanceof FillFigure filled) {
            rule.show(filled.rule().name());
            brush.show(filled.brush().code());
        }
        boolean seed = figure instanceof SeedFigure;
        column.showRow(connectivity, seed);
        column.showRow(color, seed);
        if (figure instanceof SeedFigure seeded) {
            connectivity.show(String.valueOf(seeded.connectivity()));
            color.show(seeded.same() ? "same" : "new");
        }
    }
}
