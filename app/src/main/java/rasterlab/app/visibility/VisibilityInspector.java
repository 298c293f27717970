package rasterlab.app.visibility;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import rasterlab.app.canvas.AboutText;
import rasterlab.app.canvas.Inspector;
import rasterlab.app.canvas.MethodChooser;
import rasterlab.app.canvas.NameChooser;
import rasterlab.app.language.Texts;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.Method;

/** The hidden-surface lab's choosers, live numbers and the explanation of the chosen method. */
final class VisibilityInspector {
    private final VisibilityLabModel model;
    private final Texts texts;
    private final Texts translations;
    private final Inspector column;
    private final NameChooser scene;
    private final MethodChooser visibility;
    private final NameChooser shading;
    private final NameChooser projection;
    private final JCheckBox edges;
    private final JCheckBox difference;
    private final JLabel theta;
    private final JLabel phi;
    private final JLabel rho;
    private final JLabel zoom;
    private final JLabel size;
    private final JLabel frameTime;
    private final JLabel wrongPixels;
    private final JLabel share;
    private final JLabel largest;
    private final AboutText about;

    VisibilityInspector(VisibilityLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        translations = Texts.of("visibility", "topic", texts.language());
        column = new Inspector(texts);

        scene =
                names(
                        "scene",
                        Scenes.names(),
                        name -> model.choose(choice -> choice.withScene(name)));
        visibility =
                new MethodChooser(
                        "method",
                        "",
                        model.methods().stream().map(Method::name).toList(),
                        name -> model.choose(choice -> choice.withVisibility(name)));
        column.row("method", visibility);
        shading =
                names(
                        "shading",
                        Renderer.shadings(),
                        name -> model.choose(choice -> choice.withShading(name)));
        projection =
                names(
                        "projection",
                        Renderer.projections(),
                        name -> model.choose(choice -> choice.withProjection(name)));
        edges = box("edges", shown -> model.choose(choice -> choice.withEdges(shown)));

        column.heading("heading.wrong");
        difference =
                box("difference", shown -> model.choose(choice -> choice.withDifference(shown)));
        wrongPixels = column.value("wrongPixels");
        share = column.value("share");
        largest = column.value("largest");

        column.heading("heading.view");
        theta = column.value("theta");
        phi = column.value("phi");
        rho = column.value("rho");
        zoom = column.value("zoom");
        frameTime = column.value("frameTime");
        size = column.value("size");

        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private NameChooser names(String key, List<String> names, Consumer<String> chosen) {
        var chooser =
                new NameChooser(key, names, name -> texts.textOr(key + "." + name, name), chosen);
        column.row(key, chooser);
        return chooser;
    }

    private JCheckBox box(String key, Consumer<Boolean> chosen) {
        var box = new JCheckBox(texts.label(key));
        box.setName(key);
        box.setMnemonic(texts.mnemonic(key));
        box.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        box.setToolTipText(texts.text(key + ".hint"));
        box.addActionListener(e -> chosen.accept(box.isSelected()));
        column.wide(box);
        return box;
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        VisibilityLabState state = model.state();
        VisibilityChoice choice = state.choice();
        var readings = new VisibilityReadings(state, texts);
        scene.show(choice.scene());
        visibility.show(choice.visibility());
        shading.show(choice.shading());
        projection.show(choice.projection());
        edges.setSelected(choice.edges());
        edges.setEnabled(model.canDrawEdges());
        difference.setSelected(choice.difference());
        theta.setText(readings.theta());
        phi.setText(readings.phi());
        rho.setText(readings.rho());
        zoom.setText(readings.zoom());
        size.setText(readings.size());
        frameTime.setText(readings.frameTime());
        wrongPixels.setText(readings.wrongPixels());
        share.setText(readings.share());
        largest.setText(readings.largest());
        model.methods().stream()
                .filter(method -> method.name().equals(choice.visibility()))
                .forEach(method -> about.show(translations, method, "", ""));
    }
}
