import java.io.File;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.formats.FunctionalSyntaxDocumentFormat;
import org.semanticweb.owlapi.formats.ManchesterSyntaxDocumentFormat;
import org.semanticweb.owlapi.formats.NTriplesDocumentFormat;
import org.semanticweb.owlapi.formats.OWLXMLDocumentFormat;
import org.semanticweb.owlapi.formats.RDFXMLDocumentFormat;
import org.semanticweb.owlapi.formats.TurtleDocumentFormat;
import org.semanticweb.owlapi.io.FileDocumentSource;
import org.semanticweb.owlapi.model.MissingImportHandlingStrategy;
import org.semanticweb.owlapi.model.OWLDocumentFormat;
import org.semanticweb.owlapi.model.OWLOntology;
import org.semanticweb.owlapi.model.OWLOntologyLoaderConfiguration;
import org.semanticweb.owlapi.model.OWLOntologyManager;

/**
 * Reads ontology files with the OWL API and writes the axioms of each beside it, as NAME.axioms, one sorted line an axiom: the second opinion of
 * tools/dev/round-trips. A file that cannot be read has one line that begins with "unreadable: ". The argument names a file of names, one a line.
 */
public final class Axioms {
    private static String line(Object axiom) {
        return axiom.toString().replaceAll("\r?\n", "\\\\n").replaceAll("_:[A-Za-z0-9_.-]+", "_:x");
    }

    /** The format by the end of a name: without it the OWL API tries all that it knows, and may take Manchester syntax for OBO. */
    private static OWLDocumentFormat format(String name) {
        switch (name.substring(name.lastIndexOf('.') + 1)) {
            case "ofn": return new FunctionalSyntaxDocumentFormat();
            case "omn": return new ManchesterSyntaxDocumentFormat();
            case "owx": return new OWLXMLDocumentFormat();
            case "rdf": return new RDFXMLDocumentFormat();
            case "nt": return new NTriplesDocumentFormat();
            default: return new TurtleDocumentFormat();
        }
    }

    private static List<String> axioms(String name) {
        List<String> lines = new ArrayList<>();
        try {
            OWLOntologyManager manager = OWLManager.createOWLOntologyManager();
            OWLOntologyLoaderConfiguration configuration = new OWLOntologyLoaderConfiguration()
                .setMissingImportHandlingStrategy(MissingImportHandlingStrategy.SILENT)
                .setFollowRedirects(false).setConnectionTimeout(1);
            manager.setOntologyLoaderConfiguration(configuration);
            manager.getIRIMappers().clear();
            manager.getIRIMappers().add(iri -> org.semanticweb.owlapi.model.IRI.create("file:///nowhere"));
            OWLOntology ontology = manager.loadOntologyFromOntologyDocument(new FileDocumentSource(new File(name), format(name)), configuration);
            ontology.axioms().forEach(axiom -> lines.add(line(axiom)));
            ontology.annotations().forEach(annotation -> lines.add("Ontology" + line(annotation)));
            Collections.sort(lines);
        } catch (Exception | StackOverflowError | OutOfMemoryError error) {
            lines.clear();
            String message = String.valueOf(error.getMessage()).trim().replaceFirst("(?s)^Problem parsing.*?\n.*?parsers.*?\n", "");
            lines.add("unreadable: " + error.getClass().getSimpleName() + ": " + message.replaceAll("[\r\n]+", " "));
        }
        return lines;
    }

    public static void main(String[] arguments) throws Exception {
        for (String name : Files.readAllLines(Paths.get(arguments[0]))) {
            try (PrintWriter out = new PrintWriter(name + ".axioms", StandardCharsets.UTF_8)) {
                axioms(name).forEach(out::println);
            }
        }
    }
}
