import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** Runs the tests of one class: each static method without parameters is one, and its name is a sentence. Needs nothing beyond the standard library. */
public final class Runner {
    private Runner() {}

    public static void main(String[] arguments) throws Exception {
        List<Method> tests = Arrays.stream(Class.forName(arguments[0]).getDeclaredMethods())
                .filter(method -> Modifier.isStatic(method.getModifiers()) && !Modifier.isPrivate(method.getModifiers()) && method.getParameterCount() == 0 && !method.isSynthetic())
                .filter(method -> arguments.length < 2 || method.getName().contains(arguments[1]))
                .sorted(Comparator.comparing(Method::getName)).toList();
        int failed = 0;
        for (Method test : tests) {
            try {
                test.setAccessible(true);
                test.invoke(null);
                System.out.println("ok      " + test.getName());
            } catch (InvocationTargetException fault) {
                ++failed;
                System.out.println("FAILED  " + test.getName());
                fault.getCause().printStackTrace(System.out);
            }
        }
        System.out.println(tests.size() - failed + " of " + tests.size() + " hold");
        System.exit(failed > 0 || tests.isEmpty() ? 1 : 0);
    }
}
