package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.joml.Matrix4d;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.MatrixFormulas;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.MatrixMode;

/** Commands, stacks and errors in words and formulas of one language. */
final class StackReadings {
    /** The number of a stack's matrices that are written out. */
    private static final int WRITTEN = 4;

    private final StackLabModel model;
    private final Texts texts;

    StackReadings(StackLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
    }

    /** A command as a program writes it; 16 numbers are left out. */
    String command(StackCommand command) {
        if (command.op() == StackOp.CUBE) return texts.text("op.cube");
        if (command.op().ordinal() <= StackOp.TEXTURE.ordinal()) return command.op().call();
        if (command.numbers().size() == 16) return command.op().call() + "(m)";
        return command.numbers().stream()
                .map(number -> Shown.number(number, 3, texts.locale()))
                .collect(
                        Collectors.joining(
                                MatrixFormulas.apart(texts.locale()),
                                command.op().call() + "(",
                                ")"));
    }

    /** The program's lines: done ones first, failed ones marked. */
    List<String> lines() {
        var lines = new ArrayList<String>();
        List<StackCommand> commands = model.choice().commands();
        for (int i = 0; i < commands.size(); i++) {
            String sign =
                    model.scene().errors().containsKey(i) ? "✗ " : i < model.step() ? "✓ " : "· ";
            lines.add(sign + (i + 1) + ". " + command(commands.get(i)));
        }
        return lines;
    }

    static String error(StackScene.Error error, StackScene scene, Texts texts) {
        return switch (error.kind()) {
            case OVERFLOW -> texts.text("error.overflow", scene.mode(), scene.mode().depth());
            case UNDERFLOW -> texts.text("error.underflow", scene.mode());
            case VALUE ->
                    texts.text(
                            "error.value",
                            texts.language() == Language.ENGLISH
                                    ? error.message()
                                    : texts.text("error.value.reason"));
        };
    }

    String newest() {
        return model.newest().map(this::command).orElse(texts.text("done.none"));
    }

    String depth(MatrixMode mode) {
        int depth = model.scene().stacks().get(mode).size();
        String text = texts.text("depth", depth, mode.depth());
        return mode == model.scene().mode() ? texts.text("depth.current", text) : text;
    }

    /** The present stack, the matrix on top first. */
    List<Formula> stack() {
        var lines = new ArrayList<Formula>();
        List<Matrix4d> matrices = model.scene().stacks().get(model.scene().mode());
        for (int i = 0; i < Math.min(WRITTEN, matrices.size()); i++) {
            String said = i == 0 ? texts.text("top") : texts.text("below", i);
            lines.add(MatrixFormulas.named(said, Chains.cells(matrices.get(i)), texts.locale()));
        }
        if (matrices.size() > WRITTEN)
            lines.add(
                    Formula.of(
                            new Formula.FormulaWords(
                                    texts.text("more", matrices.size() - WRITTEN))));
        return lines;
    }
}
